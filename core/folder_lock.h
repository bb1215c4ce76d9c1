#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "core/result.h"

namespace unietp {

/// `path` as the system knows it, without links and a slash at the end, so that each folder has one name.
std::filesystem::path one_name_of(const std::filesystem::path& path);

/// The right of one process to make, change or replace a folder, held in the file `<folder>.lock` beside it, in which
/// it says who it is. The system gives the right back when the process ends, however it ends, so that a file that is
/// left over stands in nobody's way.
class FolderLock {
 public:
  /// Errors: Usage when another process has the right, naming it; Io when the file cannot be made.
  static Result<FolderLock> take(const std::filesystem::path& folder);
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&&) = delete;
  ~FolderLock();  // removes the file and gives the right back

  /// An earlier holder was killed: its file was still there.
  bool was_left_over() const { return was_left_over_; }

 private:
  FolderLock(std::filesystem::path path, int file, bool left_over)
      : path_(std::move(path)), file_(file), was_left_over_(left_over) {}
  std::filesystem::path path_;
  int file_ = -1;  // descriptor
  bool was_left_over_ = false;
};

/// A folder that is read, held open to notice when another process puts a new one in its place.
class FolderWatch {
 public:
  /// Errors: Io.
  static Result<FolderWatch> begin(const std::filesystem::path& folder);
  FolderWatch(FolderWatch&& other) noexcept;
  FolderWatch& operator=(FolderWatch&&) = delete;
  ~FolderWatch();

  /// Errors: Usage when the name now leads to another folder, so that what was read may be of both.
  Result<Done> check_same() const;

 private:
  FolderWatch(std::filesystem::path folder, int file) : folder_(std::move(folder)), file_(file) {}
  std::filesystem::path folder_;
  int file_ = -1;  // descriptor
};

}  // namespace unietp
