#include "validator/file_check.h"

#include <algorithm>

#include "core/file_digest.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> files_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code code;
  for (auto it = fs::recursive_directory_iterator(folder, code); !code && it != fs::recursive_directory_iterator();
       it.increment(code)) {
    if (it->is_symlink(code) || !it->is_directory(code))
      names.push_back(it->path().lexically_relative(folder).generic_string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

FileCheck::FileCheck(fs::path folder, const ManifestRecord& manifest)
    : folder_(std::move(folder)), manifest_(manifest) {
  const auto present = files_in(folder_);
  for (const auto& [path, file] : manifest_.files) {
    if (std::binary_search(present.begin(), present.end(), path)) {
      files_.push_back(path);
    } else {
      listing_.push_back(problem_in(ProblemKind::MissingFile, path, "is listed in the manifest but missing"));
    }
  }
  for (const auto& path : present) {
    if (path != kManifest && manifest_.files.count(path) == 0)
      listing_.push_back(problem_in(ProblemKind::UnlistedFile, path, "is not listed in the manifest"));
  }
}

std::vector<Problem> FileCheck::of(const std::string& path) const {
  const auto& recorded = manifest_.files.at(path);
  const auto digest = digest_of_file(folder_, path, recorded.bytes);
  if (!digest) {
    Problem problem{ProblemKind::Unreadable, "", digest.error()};
    return {std::move(problem)};
  }
  if (digest->bytes != recorded.bytes)
    return {problem_in(
        ProblemKind::ChangedFile, path,
        "has " + std::to_string(digest->bytes) + " bytes, but the manifest lists " + std::to_string(recorded.bytes))};
  if (digest->sha256 != recorded.sha256)
    return {problem_in(ProblemKind::ChangedFile, path, "its SHA-256 differs from the manifest")};
  return {};
}

}  // namespace unietp
