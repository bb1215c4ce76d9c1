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

inline constexpr const char* kTasksFile = "tasks.jsonl";
inline constexpr const char* kWordingsFile = "wordings.jsonl";
std::string demonstrations_file(Mode mode);  // "demonstrations/M1.jsonl"

/// The modes that a data set has demonstrations of, in the order of kModes.
std::vector<Mode> shown_modes(const std::filesystem::path& folder);

/// The files to read beside tasks.jsonl. Each has one line for each task, in the order of the tasks.
struct DatasetParts {
  std::vector<Mode> modes;  // of which demonstrations are read
  bool wordings = false;    // wordings.jsonl, which must be there
  bool starts = false;      // start scenes, which are made of the homes
};

/// The line of a task in one of these files.
struct PartLine {
  std::optional<FileLine> line;  // nullopt: it has none
  Error missing;                 // why there is none: what stands in its place
};

/// A line where the file should have that of another task, or should end.
struct StrayLine {
  std::optional<Mode> mode;  // of the demonstrations; nullopt: wordings
  std::string task;          // that the line names; "" when it names none
  bool is_sound = true;      // false: the line has a fault, whatever it says
  Error error;
};

/// The lines of one task, not parsed yet.
struct TaskLines {
  FileLine task;
  std::string id;  // that the task's line states in one of its first fields; "" when it does not
  std::array<PartLine, kModes.size()> shown;  // by mode
  PartLine wordings;
  std::vector<StrayLine> strays;  // that stand in front of these lines

  const PartLine& shown_in(Mode mode) const { return shown[static_cast<std::size_t>(mode)]; }
};

/// Goes through the files of a data set in step, task by task. Memory does not grow with the data set.
class DatasetLines {
 public:
  /// Errors: Io, for a file that is missing or cannot be opened.
  static Result<DatasetLines> open(const std::filesystem::path& folder, const DatasetParts& parts, FileNames names);

  /// The lines of the next task; nullopt after the last. A line that names another task than the one in its place is
  /// put right within kLookAheadBytes: when the task's own line follows there, what is in front of it is stray;
  /// otherwise the task has no line.
  std::optional<TaskLines> next();
  /// After the last task: the next line that is left over; nullopt when there is none.
  std::optional<StrayLine> next_stray();

  /// A line of tasks.jsonl as errors name it: "tasks.jsonl:3".
  std::string task_at(int line) const { return tasks_.at(line); }
  /// A line of a mode's demonstrations, and of the wordings, likewise.
  std::string shown_at(Mode mode, int line) const;
  std::string wordings_at(int line) const;

 private:
  static constexpr std::size_t kLookAheadBytes = std::size_t{64} << 20;

  /// A file beside tasks.jsonl, with the lines that were read ahead.
  struct Beside {
    std::optional<Mode> mode;  // nullopt: wordings
    std::optional<LineFile> file;
    std::deque<std::pair<FileLine, std::string>> ahead;  // with the task that the line names
    std::size_t bytes_ahead = 0;
    int lines = 0;  // that were read

    bool read_ahead();
    std::optional<std::size_t> find(std::string_view task);
    std::pair<FileLine, std::string> pop();
    PartLine take(const std::string& task, std::vector<StrayLine>& strays);
  };

  explicit DatasetLines(LineFile tasks) : tasks_(std::move(tasks)) {}

  LineFile tasks_;
  std::vector<Beside> beside_;
};

}  // namespace unietp
