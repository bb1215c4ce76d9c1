#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "core/folder_lock.h"
#include "core/result.h"

namespace unietp {

/// A `Usage` error about a folder or file that was named on the command line.
Error usage_error(const std::filesystem::path& path, std::string message);

/// `<out>.partial`, one run's at a time: it holds the ledger and the growing data set, which becomes `<out>` by one
/// rename. Destruction without `publish` keeps the folder for a later `--resume`.
class RunFolder {
 public:
  /// `identity`: all that decides what the run makes, as JSON; it is kept in the folder, and only a run with the same
  /// one may go on there. Errors: Usage when `out` exists, when an unfinished run is there and `resume` is not asked
  /// for, when it is another run or an older version's, and when another process is working on `out`, each without
  /// touching what is there; Io when the folder cannot be made or written.
  static Result<RunFolder> enter(const std::filesystem::path& out, const std::string& identity, bool resume);

  /// An earlier process was killed after it had published the data set and before it had cleaned up; `enter` did that.
  bool already_published() const { return already_published_; }
  std::filesystem::path ledger() const { return folder_ / "ledger.sqlite"; }
  /// An empty folder for the data set. Errors: Io.
  Result<std::filesystem::path> fresh_data_folder() const;
  /// Renames the data folder to `out` and removes the rest. Errors: Io.
  Result<Done> publish();

 private:
  RunFolder(FolderLock lock, std::filesystem::path out, std::filesystem::path folder)
      : lock_(std::move(lock)), out_(std::move(out)), folder_(std::move(folder)) {}
  FolderLock lock_;
  std::filesystem::path out_, folder_;
  bool already_published_ = false;
};

}  // namespace unietp
