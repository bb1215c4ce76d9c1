#include "generator/gate.h"

#include <algorithm>
#include <array>

namespace unietp {
namespace {

struct GateInfo {
  Gate gate;
  std::string_view name, meaning;
};
constexpr std::array<GateInfo, 12> kGates{{
    {Gate::Simulator, "simulator", "the template supports the simulator"},
    {Gate::Placeholder, "placeholder", "every placeholder is bound to something in the knowledge base"},
    {Gate::Affordance, "affordance", "each category has the affordances of its placeholder"},
    {Gate::Constraint, "constraint", "the template's constraints on categories hold"},
    {Gate::StateOfCategory, "state_of_category", "the goal uses only states that its categories have"},
    {Gate::ExclusiveStates, "exclusive_states", "the goal never requires two exclusive states"},
    {Gate::OnePlace, "one_place", "the goal never requires one object in two places"},
    {Gate::Capacity, "capacity", "the objects fit where the goal requires them"},
    {Gate::Counts, "counts", "the goal never requires two different numbers of the same objects"},
    {Gate::Start, "start", "some start satisfies the start constraints"},
    {Gate::FalseAtStart, "false_at_start", "each part of the goal is false in every start"},
    {Gate::Reachable, "reachable", "the simulator's actions can make each part of the goal true"},
}};

const GateInfo& info(Gate gate) { return kGates[static_cast<std::size_t>(gate)]; }

}  // namespace

std::string_view name_of(Gate gate) { return info(gate).name; }
std::string rejection_of(Gate gate) {
  auto reason = "gate-" + std::string(name_of(gate));
  std::replace(reason.begin(), reason.end(), '_', '-');
  return reason;
}
std::string_view meaning_of(Gate gate) { return info(gate).meaning; }

}  // namespace unietp
