#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "annotator/instruction.h"
#include "core/file_writer.h"
#include "core/result.h"
#include "dataset/task_purpose.h"
#include "logic/formula.h"
#include "scene/action.h"
#include "scene/command.h"
#include "scene/trace.h"
#include "scene/visible_object.h"
#include "sense/grade_goal.h"

namespace unietp {

// The lines of a data set's files, as values; `line_of` returns the text of a line without its line feed. The formats
// are described in docs/files.md and data/schemas/; tests check each kind of line against its schema.

/// A line of tasks.jsonl.
struct TaskEntry {
  std::string id, template_name, split, simulator, scene, layout;
  std::vector<std::pair<std::string, std::string>> bindings;  // placeholder, category
  std::string refinement;                                     // name of the referring constraint, or ""
  std::string goal_text;
  Formula goal;
  std::vector<std::string> start_constraints, edits;
  std::string changes;  // JSON of the Delta that makes the start of the home (scene/scene_json.h)
  Instruction instruction;
  TaskPurpose purpose;
  TaskSense sense;
  std::vector<std::string> forms;  // of its simulator that express it (scene/simulator_forms.h)
  struct Count {
    Mode mode = Mode::M1;
    int steps = 0, failures = 0;
    int shortest = 0;  // of the shortest plan known, without search and tidying; written in M1 only where it is not 0
    bool operator==(const Count&) const = default;
  };
  std::vector<Count> expert;  // of its demonstrations
  std::uint64_t run_seed = 0;
  int slot = 0, attempt = 0;
};
/// Format `unietp-task/1`. Equal entries give equal bytes.
std::string line_of(const TaskEntry& task);

/// A step of a demonstration; refers to values that outlive it.
struct StepEntry {
  const Command& command;
  bool success;
  std::string_view failure, feedback;
  const std::vector<VisibleObject>& visible;
  const Delta& changes;
  const std::vector<Delta>& moments;  // written where there are any
  bool search = false;
  bool tidying = false;  // written where it is true
};
/// Plans beside a demonstration, with objects by their ids.
struct PlansBeside {
  std::vector<Command> shortest;  // written except in M1
  std::vector<Command> tempting;  // written where there is one
};
/// A line of demonstrations/<mode>.jsonl.
std::string demonstration_line(std::string_view task, Mode mode, const std::vector<StepEntry>& steps,
                               const PlansBeside& beside = {});

/// A line of rejections.jsonl.
struct RejectionEntry {
  int slot = 0, attempt = 0;
  std::string template_name, simulator, split, stage, reason, detail;
  bool operator==(const RejectionEntry&) const = default;
};
/// Format `unietp-rejection/1`.
std::string line_of(const RejectionEntry& rejection);

/// A line of wordings.jsonl: one episode in several wordings.
struct WordingsEntry {
  std::string task;
  Instruction direct;
  std::optional<Instruction> referring;
  std::string referring_goal;  // that `referring` states
  std::optional<Instruction> complex;
  std::optional<Instruction> contrast;
  std::string contrast_goal;        // that `contrast` states
  std::vector<Instruction> others;  // further texts that mean the task's goal, no two texts alike
};
/// Format `unietp-wordings/1`.
std::string line_of(const WordingsEntry& wordings);

/// A line of reviews.jsonl: a person's verdict that is in force.
struct ReviewMarkEntry {
  std::string task, verdict;
  std::string before;  // the instruction that an edit replaced; "" for other verdicts
  std::string comment;
};
/// Format `unietp-review-mark/1`.
std::string line_of(const ReviewMarkEntry& mark);

/// A file of such lines, written one after the other.
class LinesWriter {
 public:
  /// Makes the file anew. Errors: Io.
  static Result<LinesWriter> begin(const std::filesystem::path& file);
  /// Errors: Io, naming the file.
  Result<Done> add(std::string_view line);
  Result<Done> finish();

 private:
  explicit LinesWriter(FileWriter file) : file_(std::move(file)) {}
  FileWriter file_;
};

}  // namespace unietp
