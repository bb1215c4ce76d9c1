#pragma once

#include <filesystem>
#include <map>

#include "program.h"

namespace unietp {

/// Counts what a run does to the files of a folder and everything below it, so that it can be stopped at moments of its
/// own progress, however busy the machine is.
class FileWatch {
 public:
  explicit FileWatch(const std::filesystem::path& folder);
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;
  ~FileWatch();

  /// Waits for something to happen, at most ten milliseconds; how many things have happened so far.
  int count();

 private:
  void add(const std::filesystem::path& folder);
  int watch_ = -1;
  int count_ = 0;
  std::map<int, std::filesystem::path> folders_;
};

/// Kills a run when it has done so much to its files; false when it ended before.
bool killed_after(RunningProgram& program, FileWatch& watch, int changes);

}  // namespace unietp
