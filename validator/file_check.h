#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "record/manifest_record.h"
#include "validator/problem.h"

namespace unietp {

/// Holds the files of a folder against their manifest: each is there, listed, and of the recorded length and SHA-256.
class FileCheck {
 public:
  FileCheck(std::filesystem::path folder, const ManifestRecord& manifest);

  /// Files that are missing, or there without being listed.
  const std::vector<Problem>& listing() const { return listing_; }
  /// The listed files that are there, in order of path.
  const std::vector<std::string>& files() const { return files_; }
  /// What is wrong with the bytes of a listed file, also that they cannot be read; empty when nothing is.
  std::vector<Problem> of(const std::string& path) const;

 private:
  std::filesystem::path folder_;
  const ManifestRecord& manifest_;
  std::vector<Problem> listing_;
  std::vector<std::string> files_;
};

}  // namespace unietp
