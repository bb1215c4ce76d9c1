#pragma once

#include <filesystem>

#include "core/result.h"

namespace unietp {

/// A `Usage` error about a folder or file that was named on the command line.
Error usage_error(const std::filesystem::path& path, std::string message);

/// `<out>.partial`, locked by one run at a time: it holds the ledger and the growing data set, which becomes
/// `<out>` by one rename. Destruction without `publish` keeps the folder for a later `--resume`.
class RunFolder {
 public:
  /// Errors: Usage when `out` exists, when an unfinished run is there and `resume` is not asked for, or when another
  /// process is working in it; Io when the folder cannot be made or written.
  static Result<RunFolder> enter(const std::filesystem::path& out, bool resume);
  RunFolder(RunFolder&& other) noexcept;
  RunFolder& operator=(RunFolder&&) = delete;
  ~RunFolder();  // releases the lock

  /// An earlier process was killed after it had published the data set and before it had cleaned up; `enter` did that.
  bool already_published() const { return already_published_; }
  std::filesystem::path ledger() const { return folder_ / "ledger.sqlite"; }
  /// An empty folder for the data set. Errors: Io.
  Result<std::filesystem::path> fresh_data_folder() const;
  /// Renames the data folder to `out` and removes the rest. Errors: Io.
  Result<Done> publish();

 private:
  RunFolder(std::filesystem::path out, std::filesystem::path folder, int lock)
      : out_(std::move(out)), folder_(std::move(folder)), lock_(lock) {}
  std::filesystem::path out_, folder_;
  int lock_ = -1;  // file descriptor
  bool already_published_ = false;
};

}  // namespace unietp
