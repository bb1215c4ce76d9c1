#include "expert/plan_cost.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>

#include "logic/formula.h"

namespace unietp {
namespace {

constexpr double kMoved_m = 0.05;

double way_to(const World& world, const Action& action) {
  const bool to_a_thing = action.type == ActionType::GoTo && world.find(action.args.front()) != nullptr;
  const double way = to_a_thing ? world.walking_distance(action.args.front()) : 0;
  return std::isfinite(way) ? way : 0;
}

struct Place {
  Vec3 position;
  bool open = false, on = false;
};

/// nullopt for what is not there.
std::optional<Place> place_in(const World& world, const std::string& id) {
  const Node* node = world.find(id);
  if (node == nullptr) return std::nullopt;
  return Place{node->pose.position, node->states.has(Predicate::Open), node->states.has(Predicate::PowerOn)};
}

}  // namespace

PlanCost cost_of(ExecutionTree& executions, const std::vector<Action>& plan) {
  World world = executions.world();
  double meters = 0;
  std::set<std::string> touched;
  for (const Action& action : plan) {
    const Vec2 from = world.agent().position;
    const double way = way_to(world, action);
    if (!executions.step(world, action).success) continue;
    const double straight = (world.agent().position - from).norm();
    meters += straight == 0 ? 0 : std::max(straight, way);
    const ActionType type = action.type;
    if (type == ActionType::Open || type == ActionType::TurnOn || type == ActionType::PickUp)
      touched.insert(action.args.front());
  }
  const auto named = categories_of(executions.goal());
  const auto is_bystander = [&](const std::string& id) {
    const Node* node = world.find(id);
    return node != nullptr && std::find(named.begin(), named.end(), node->category) == named.end();
  };
  PlanCost cost{static_cast<int>(plan.size()), static_cast<int>(std::lround(meters))};
  for (const std::string& id : touched) {
    const auto before = place_in(executions.world(), id), after = place_in(world, id);
    if (!before || !after) continue;
    const bool opened = after->open && !before->open, turned_on = after->on && !before->on;
    const bool moved = (after->position - before->position).norm() > kMoved_m;
    cost.steps += (opened ? 1 : 0) + (turned_on ? 1 : 0);
    cost.disturbed += (opened || turned_on || moved) && is_bystander(id) ? 1 : 0;
  }
  return cost;
}

}  // namespace unietp
