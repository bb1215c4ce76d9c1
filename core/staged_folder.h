#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>

#include "core/folder_lock.h"
#include "core/result.h"

namespace unietp {

/// A folder that grows aside, in `<target>.writing`, and gets its name by one rename, so that readers see the old
/// folder or the new, never half, and that what fails leaves all as it was. It is one process's at a time.
class StagedFolder {
 public:
  /// Takes the lock of `target`, and an empty folder aside; what a killed process left there goes. `may_replace`: the
  /// target may be there, and is replaced. Errors: Usage when the target is there, is another process's, or something
  /// of the user's has the name aside; Io.
  static Result<StagedFolder> begin(const std::filesystem::path& target, bool may_replace);
  StagedFolder(StagedFolder&& other) noexcept
      : lock_(std::move(other.lock_)),
        target_(std::move(other.target_)),
        aside_(std::exchange(other.aside_, std::filesystem::path())) {}
  StagedFolder& operator=(StagedFolder&&) = delete;
  ~StagedFolder();  // removes the folder aside unless it is finished

  const std::filesystem::path& folder() const { return aside_; }  // where to write until it is finished
  /// Puts the folder in place. Errors: Io.
  Result<Done> finish();

 private:
  StagedFolder(FolderLock lock, std::filesystem::path target, std::filesystem::path aside)
      : lock_(std::move(lock)), target_(std::move(target)), aside_(std::move(aside)) {}
  FolderLock lock_;
  std::filesystem::path target_, aside_;  // `aside_` is empty when there is nothing to remove
};

/// A folder made from the data set in `source`: `write` fills it aside. Errors: those of StagedFolder and `write`;
/// Usage when another process replaced the source meanwhile. Then nothing stays.
Result<Done> write_staged_folder(const std::filesystem::path& source, const std::filesystem::path& target,
                                 const std::function<Result<Done>(const std::filesystem::path& aside)>& write);

/// A copy of a data set's folder in which some files will be other ones.
class ChangedCopy {
 public:
  /// `target` is `source` itself, or a name that is free. Files that `is_new` does not name stay as they are: linked
  /// where the source is replaced, otherwise copied. Call it before reading the source, so that nobody changes it
  /// between. Errors: those of StagedFolder.
  static Result<ChangedCopy> begin(const std::filesystem::path& source, const std::filesystem::path& target,
                                   const std::function<bool(const std::string& file)>& is_new);
  const std::filesystem::path& folder() const { return staged_.folder(); }
  /// Puts the copy in place; a replaced folder is removed. Errors: Io; Usage as above.
  Result<Done> finish();

 private:
  ChangedCopy(FolderWatch source, StagedFolder staged) : source_(std::move(source)), staged_(std::move(staged)) {}
  FolderWatch source_;
  StagedFolder staged_;
};

}  // namespace unietp
