#pragma once

#include <nlohmann/json.hpp>

#include "akb/knowledge.h"
#include "exports/ai2thor_plan.h"
#include "logic/trace.h"
#include "record/dataset_reader.h"

namespace unietp {

/// A goal that AI2-THOR's metadata decides.
struct ThorGoal {
  std::string formula;                          // as LTLf (ltlf_formula.h) has it
  nlohmann::ordered_json propositions;          // `{"name", "predicate", "arguments", "test"}` for each that it names
  std::vector<nlohmann::ordered_json> holding;  // for the start and after each step, names of those that hold
  std::set<std::string> objects;                // ids of the objects that it names
};

/// The goal of a task among what is in the house alone: quantifiers range over it. `names` has every object of the
/// house, and `task` none but these. Errors: Unsatisfiable with the reason: what LTLf does not say, what the metadata
/// does not tell, a goal that holds at the start or not after the demonstration, seen so.
Result<ThorGoal> thor_goal(const FinishedTask& task, const ThorNames& names, const Knowledge& knowledge);

}  // namespace unietp
