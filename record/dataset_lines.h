#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/result.h"
#include "record/line_file.h"
#include "scene/action.h"

namespace unietp {

/// File names in a data set's folder (docs/files.md).
inline constexpr const char* kTasksFile = "tasks.jsonl";
inline constexpr const char* kWordingsFile = "wordings.jsonl";
std::string demonstrations_file(Mode mode);  // "demonstrations/M1.jsonl"

/// The modes that a data set has demonstrations of, in the order of kModes.
std::vector<Mode> shown_modes(const std::filesystem::path& folder);

/// The parts to read in addition to tasks.jsonl. Each of the files has one line per task, in the order of the tasks.
struct DatasetParts {
  std::vector<Mode> modes;  // of which demonstrations are read
  bool wordings = false;    // wordings.jsonl, which must be there
  bool starts = false;      // start scenes, which are computed from the homes
};

/// The line of a task in one of these files.
struct PartLine {
  std::optional<FileLine> line;  // nullopt: the file has none for this task
  Error missing;                 // for that case: what the file has in its place
};

/// A line in the place of another task's line, or after the last one.
struct StrayLine {
  std::optional<Mode> mode;  // of the demonstrations; nullopt: wordings
  std::string task;          // named in the line; "" when it names none
  bool is_sound = true;      // false: the line has a fault (line_file.h)
  Error error;
};

/// The lines of one task, not parsed yet.
struct TaskLines {
  FileLine task;
  std::string id;                             // from one of the first fields of the line; "" when it is not there
  std::array<PartLine, kModes.size()> shown;  // by mode
  PartLine wordings;
  std::vector<StrayLine> strays;  // before these lines

  const PartLine& shown_in(Mode mode) const { return shown[static_cast<std::size_t>(mode)]; }  // the demonstration
};

/// Reads the files of a data set side by side, task by task. Memory use does not depend on the number of tasks.
class DatasetLines {
 public:
  /// Errors: Io, for a file that is missing or cannot be opened.
  static Result<DatasetLines> open(const std::filesystem::path& folder, const DatasetParts& parts, FileNames names);

  /// The lines of the next task; nullopt after the last. If a file has the line of a different task here, the task's
  /// own line is searched in the next kLookAheadBytes: the lines before it are strays. If it is not found, it is
  /// missing.
  std::optional<TaskLines> next();
  /// After the last task: the next line that belongs to no task; nullopt when there is none.
  std::optional<StrayLine> next_stray();

  /// A line of tasks.jsonl for error messages: "tasks.jsonl:3".
  std::string task_at(int line) const { return tasks_.at(line); }
  /// A line of a mode's demonstrations, and of the wordings, likewise.
  std::string shown_at(Mode mode, int line) const;
  std::string wordings_at(int line) const;

 private:
  static constexpr std::size_t kLookAheadBytes = std::size_t{16} << 20;

  /// A file with a line per task, and the lines read ahead.
  struct PartFile {
    std::optional<Mode> mode;  // nullopt: wordings
    std::optional<LineFile> file;
    std::deque<std::pair<FileLine, std::string>> ahead;  // with the task named in the line
    std::size_t bytes_ahead = 0;
    int lines = 0;  // read so far

    bool read_ahead();
    std::optional<std::size_t> find(std::string_view task);
    std::pair<FileLine, std::string> pop();
    PartLine take(const std::string& task, std::vector<StrayLine>& strays);
  };

  explicit DatasetLines(LineFile tasks) : tasks_(std::move(tasks)) {}

  LineFile tasks_;
  std::vector<PartFile> parts_;
};

}  // namespace unietp
