#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/result.h"
#include "record/task_record.h"
#include "scene/scene.h"

namespace unietp {

/// Ids of a running AI2-THOR scene by ours: those of the house (`write_procthor`), and of slices as they appear.
using ThorNames = std::map<std::string, std::string>;

/// That AI2-THOR cannot express a task.
Error thor_lacks(std::string why);

/// How a controller follows a demonstration: a list of `{"step", "calls"}`, one for each successful step but `stop`.
/// `names` also gets the slices that it cuts. Errors: Unsatisfiable with the reason, for an object that is not in the
/// house and an action that AI2-THOR does not have.
Result<nlohmann::ordered_json> thor_plan(const DemonstrationRecord& demonstration, Scene start, ThorNames& names);

/// What makes the start of a house: `{"unless", "call"}`, a test of the metadata and what to call where it fails. All
/// states of the objects in `used`, of others those that are not as usual; which of these AI2-THOR cannot set goes to
/// `differs`, for people. Errors: Unsatisfiable, for such a state of a used object.
Result<nlohmann::ordered_json> thor_start(const Scene& start, const ThorNames& names, const std::set<std::string>& used,
                                          std::vector<std::string>& differs);

/// The tables of `thor_states` and `thor_actions` for a program that acts: `states` (our state, its group of states
/// that exclude each other, key of the metadata and its value; that of a liquid is its name) and `actions` (our action,
/// the tool where it matters, and its calls, each with whom it is `of` and `when` a step needs it).
nlohmann::ordered_json thor_words();

/// A test of one object's metadata for one of its states. nullopt when the metadata does not tell it.
std::optional<nlohmann::ordered_json> thor_test(const State& state, const std::string& object);

}  // namespace unietp
