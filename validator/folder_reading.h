#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "record/task_record.h"
#include "scene/action.h"
#include "validator/problem.h"

namespace unietp {

/// A file of lines, whole in memory; a line is read when it is asked for.
class LineFile {
 public:
  /// A file that is not there has no lines. Errors: Io.
  static Result<LineFile> read(const std::filesystem::path& folder, std::string name);

  const std::string& name() const { return name_; }
  const std::string& bytes() const { return bytes_; }
  std::size_t size() const { return starts_.empty() ? 0 : starts_.size() - 1; }
  std::string_view line(std::size_t index) const;
  std::string at(std::size_t index) const { return name_ + ":" + std::to_string(index + 1); }

 private:
  std::string name_, bytes_;
  std::vector<std::size_t> starts_;  // of each line, and one past the last
};

/// A line of tasks.jsonl with the lines that show it.
struct TaskReading {
  std::string name;  // its id, or the best guess at it where the line does not read
  std::string where;
  Result<TaskRecord> record = Error{};
  std::array<std::optional<std::size_t>, kModes.size()> shown;  // lines of demonstrations/<mode>.jsonl, by mode
};

std::string demonstrations_file(Mode mode);  // "demonstrations/M1.jsonl"

/// A finished data set's tasks, and its demonstrations by line: what everyone who reads such a folder begins with.
struct FolderReading {
  std::filesystem::path folder;
  LineFile task_lines;
  std::array<LineFile, kModes.size()> demonstrations;  // by mode; without lines where the mode was not asked for
  std::vector<TaskReading> tasks;                      // in the order of tasks.jsonl

  /// A demonstration. Errors: those of read_demonstration.
  Result<DemonstrationRecord> demonstration(Mode mode, std::size_t line) const;
};

/// What cannot be read is a problem of its task; demonstrations are found by the task that their line names. Errors: Io
/// when there is no tasks.jsonl or a file cannot be read.
Result<FolderReading> read_folder(const std::filesystem::path& folder, std::vector<Problem>& problems);

}  // namespace unietp
