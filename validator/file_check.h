#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "record/manifest_record.h"
#include "validator/problem.h"

namespace unietp {

/// Compares the files of a folder with its manifest: which are missing or not listed, length and SHA-256 of each.
class FileCheck {
 public:
  FileCheck(std::filesystem::path folder, const ManifestRecord& manifest);

  /// Files that are missing, or there without being listed.
  const std::vector<Problem>& listing() const { return listing_; }
  /// The listed files that are there, in order of path.
  const std::vector<std::string>& files() const { return files_; }
  /// Problems of the content of a listed file, or that it cannot be read; empty when it is as recorded.
  std::vector<Problem> of(const std::string& path) const;

 private:
  std::filesystem::path folder_;
  const ManifestRecord& manifest_;
  std::vector<Problem> listing_;
  std::vector<std::string> files_;
};

}  // namespace unietp
