#pragma once

#include <map>
#include <string>
#include <vector>

#include "logic/formula.h"
#include "scene/action.h"
#include "simulation/world.h"
#include "validator/trace_maker.h"

namespace unietp {

/// What a careful person would not do, or not without need.
enum class CarelessKind {
  Parked,        // a thing is put down, another is handled, and the thing is fetched again
  Moved,         // what the goal does not speak of and nothing is done with lies elsewhere at the end
  MovedFreely,   // of these: the goal is reached as well if it is left alone
  FarAway,       // a device in another room is used, though one of its kind that is nearer would do
  LeftOpenOrOn,  // what was opened or turned on is so at the end, though it could be set back
};
inline constexpr CarelessKind kCarelessKinds[] = {CarelessKind::Parked, CarelessKind::Moved, CarelessKind::MovedFreely,
                                                  CarelessKind::FarAway, CarelessKind::LeftOpenOrOn};
/// For tables: "bystanders left elsewhere".
std::string_view name_of(CarelessKind kind);

/// What of that a plan does: for each kind the things, by id, each once, sorted.
using Carelessness = std::map<CarelessKind, std::vector<std::string>>;

/// Of a plan for a goal, of actions on ids that all succeed, without `stop`. Whether something else would do is tried
/// in physics, by one who is told where everything is.
Carelessness carelessness_of(const Formula& goal, const World& start, const TraceMaker& traces,
                             const std::vector<Action>& plan);

}  // namespace unietp
