#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/result.h"
#include "logic/formula.h"
#include "scene/command.h"
#include "scene/trace.h"
#include "scene/visible_object.h"

namespace unietp {

/// A line of tasks.jsonl (docs/files.md).
struct TaskRecord {
  std::string id, template_name, split, simulator, scene, layout;
  std::vector<std::pair<std::string, std::string>> bindings;  // placeholder, category; in the order of the line
  std::string refinement;                                     // name of the referring constraint, or ""
  std::vector<std::string> phenomena;                         // of language that the text shows
  std::string goal_text;
  Formula goal_tree;
  std::vector<std::string> start_constraints, edits;
  Delta changes;  // of the home, which make the start
  std::string instruction, writer, style;
  std::vector<std::string> checks;   // names of the checks that the text passed
  std::string fallback;              // why the grammar wrote the text instead of a model; "" otherwise
  int phrasing = 0;                  // the template's own that the text is, counted from 1; 0: none
  std::string purpose;               // what it is for in a home; "" where its template does not say
  std::vector<std::string> because;  // what in its start makes it needed
  std::string grade;                 // of its sense
  struct SensePart {
    std::string part, grade, why;
    bool operator==(const SensePart&) const = default;
  };
  std::vector<SensePart> sense;    // worst first
  std::vector<std::string> forms;  // of its simulator that express it
  struct Count {
    Mode mode = Mode::M1;
    int steps = 0, failures = 0;
    int shortest = 0;  // of the shortest plan kept beside it; in M1 without steps that only tidy up, 0: there are none
  };
  std::uint64_t run = 0;  // seed of the run
  int slot = 0, attempt = 0;
  std::vector<Count> expert;  // of its demonstrations, in the order of the modes; M1 is always there
};

/// Reads every field strictly. Errors: Parse with line and column; Schema with a JSON pointer for a missing, unknown or
/// mistyped field. `where` is the file's name; `line` the line's number in it.
Result<TaskRecord> read_task(std::string_view where, int line, std::string_view text);

/// A step of a demonstration. The action exists and has the right number of arguments.
struct StepRecord {
  Command command;
  bool success = false;
  std::string failure, feedback;
  std::vector<VisibleObject> visible;
  Delta changes;
  std::vector<Delta> moments = {};  // from moment to moment, where the action passes through several; else empty
  bool search = false;              // only served to see something
  bool tidying = false;             // only sets back what was opened or turned on before
};
/// A line of demonstrations/<mode>.jsonl.
struct DemonstrationRecord {
  std::string task, mode;
  std::vector<StepRecord> steps;
  std::vector<Command> shortest = {};  // except in M1: a plan of one who is told everything
  std::vector<Command> tempting = {};  // in M1, where the goal has constraints: a plan that breaks them
};
/// What each step of a demonstration changed, from moment to moment.
std::vector<Delta> changes_by_moment(const DemonstrationRecord& demonstration);
/// As read_task.
Result<DemonstrationRecord> read_demonstration(std::string_view where, int line, std::string_view text);

/// What a demonstration does, without what became of it.
struct DemonstratedPlan {
  std::string task;
  std::vector<Command> commands;  // of its steps
};
/// The same line, in less than half the time: looks at the task and the commands alone.
Result<DemonstratedPlan> read_demonstrated_plan(std::string_view where, int line, std::string_view text);

/// A line of rejections.jsonl.
struct RejectionRecord {
  int slot = 0, attempt = 0;
  std::string template_name, simulator, split, stage, reason, detail;

  /// Whether a person took the task out after it was made. Other stages are steps of the run.
  bool is_by_review() const { return stage == "review"; }
};
/// As read_task.
Result<RejectionRecord> read_rejection(std::string_view where, int line, std::string_view text);

}  // namespace unietp
