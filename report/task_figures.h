#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "record/dataset_reader.h"
#include "report/formula_census.h"
#include "report/goal_things.h"

namespace unietp {

/// Counts by name.
using Tally = std::map<std::string, int>;

/// What the statistics of a data set count of one task.
struct TaskFigures {
  struct Plan {
    int steps = 0, failed = 0;
    Tally actions;
  };
  std::string id, simulator, split, template_name, layout, purpose, style;
  std::vector<std::string> phenomena;
  std::string writer;
  std::string instruction;
  std::vector<std::string> words;       // of the instruction, lower case, in order
  std::vector<std::string> categories;  // that its template is bound to
  /// Of each part of the goal for which any of several categories serves: these, in order of name.
  std::vector<std::vector<std::string>> alternatives;
  FormulaCensus goal;
  std::map<Mode, Plan> plans;  // of the demonstrations that were read
  TaskGoalThings things = {};
};

/// Deterministic.
TaskFigures figures_of(const FinishedTask& task);

/// Whether a word only connects others (a, the, of, …). `word`: lower case.
bool is_function_word(std::string_view word);

}  // namespace unietp
