#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/result.h"

namespace unietp {

/// A copy of a data set's folder in which some files will be other ones. The copy grows beside the place where it shall
/// stand and gets there by one rename, so that readers see the old folder or the new, never half.
class ChangedCopy {
 public:
  /// `target` is `source` itself, or a name that is free. Files but `changed` are linked, or copied where the file
  /// system has no links. Errors: Usage, when the target is taken; Io.
  static Result<ChangedCopy> begin(const std::filesystem::path& source, const std::filesystem::path& target,
                                   const std::vector<std::string>& changed);

  const std::filesystem::path& folder() const { return folder_; }
  /// Puts the copy in place; a replaced folder is removed. Errors: Io.
  Result<Done> finish();

 private:
  ChangedCopy(std::filesystem::path folder, std::filesystem::path target, bool replaces)
      : folder_(std::move(folder)), target_(std::move(target)), replaces_(replaces) {}
  std::filesystem::path folder_, target_;
  bool replaces_ = false;
};

}  // namespace unietp
