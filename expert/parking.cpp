#include "expert/parking.h"

#include <algorithm>
#include <optional>
#include <span>

#include "expert/execution.h"
#include "expert/plan_cost.h"
#include "simulation/mode_rules.h"

namespace unietp {
namespace {

constexpr std::size_t kLongestDetour = 3;

bool puts_down(const Action& action) { return action.type == ActionType::PlaceOn || action.type == ActionType::Drop; }

/// Of a plan, by position: a thing is taken, put down again, and taken once more; only others are handled in between.
struct Parking {
  std::size_t way, taken, parked, fetched;  // `way`: of the first action that leads to the thing
};

std::optional<std::size_t> next_pick_up(const std::vector<Action>& plan, std::size_t from, const std::string* id) {
  for (std::size_t i = from; i < plan.size(); ++i)
    if (plan[i].type == ActionType::PickUp && (id == nullptr || plan[i].args.front() == *id)) return i;
  return std::nullopt;
}

/// The first at or after a position.
std::optional<Parking> parking_in(const std::vector<Action>& plan, std::size_t from, std::size_t done) {
  for (auto taken = next_pick_up(plan, from, nullptr); taken; taken = next_pick_up(plan, *taken + 1, nullptr)) {
    const auto fetched = next_pick_up(plan, *taken + 1, &plan[*taken].args.front());
    if (!fetched) continue;
    const auto other = next_pick_up(plan, *taken + 1, nullptr);
    if (*other == *fetched) continue;  // the hand was not needed for another
    std::size_t parked = *other;
    while (parked > *taken && !puts_down(plan[parked])) --parked;
    if (parked == *taken) continue;
    std::size_t way = *taken;
    while (way > done && only_leads_somewhere(plan[way - 1])) --way;
    return Parking{way, *taken, parked, *fetched};
  }
  return std::nullopt;
}

/// Two ways to handle the others first: right away, or when all is done but for the thing that leads to them (what
/// they are in is opened). Steps that lead to nothing are left in.
std::vector<std::vector<Action>> with_others_first(const std::vector<Action>& plan, const Parking& parking) {
  const auto at = [&plan](std::size_t i) { return plan.begin() + static_cast<std::ptrdiff_t>(i); };
  const auto goes_to = [&at](std::size_t from, std::size_t to) {
    const auto first = std::find_if_not(at(from), at(to), only_leads_somewhere);
    return first == at(to) || first->args.empty() ? Action{ActionType::TurnLeft, {}}
                                                  : Action{ActionType::GoTo, first->args};
  };
  const Action to_thing{ActionType::GoTo, plan[parking.taken].args};
  const auto add = [&at](std::vector<Action>& changed, std::size_t from, std::size_t to) {
    changed.insert(changed.end(), at(from), at(to));
  };
  std::vector<Action> now(at(0), at(parking.way)), later = now;
  now.push_back(goes_to(parking.parked + 1, parking.fetched));
  add(now, parking.parked + 1, parking.fetched);
  now.push_back(to_thing);
  add(now, parking.taken, parking.parked);
  add(now, parking.fetched + 1, plan.size());

  add(later, parking.taken + 1, parking.parked);
  add(later, parking.parked + 1, parking.fetched);
  later.push_back(to_thing);
  later.push_back(plan[parking.taken]);
  later.push_back(goes_to(parking.fetched + 1, plan.size()));
  add(later, parking.fetched + 1, plan.size());
  return {std::move(now), std::move(later)};
}

}  // namespace

std::vector<Action> without_parking(ExecutionTree& executions, std::vector<Action> plan, std::size_t done) {
  for (std::size_t from = done; const auto parking = parking_in(plan, from, done);) {
    auto best = plan;
    PlanCost least = cost_of(executions, plan);
    for (auto& changed : with_others_first(plan, *parking)) {
      auto needed = without_needless(executions, rules_of(Mode::M1), std::move(changed), kLongestDetour, done);
      if (!needed) continue;
      const PlanCost cost = cost_of(executions, *needed);
      if (cost < least) best = std::move(*needed), least = cost;
    }
    if (best == plan) from = parking->taken + 1;
    plan = std::move(best);
  }
  return plan;
}

}  // namespace unietp
