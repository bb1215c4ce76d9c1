#include "generator/gate.h"

#include <array>

namespace unietp {
namespace {

struct GateInfo {
  Gate gate;
  RejectionReason reason;
  std::string_view name, meaning;
};
constexpr std::array<GateInfo, 12> kGates{{
    {Gate::Simulator, RejectionReason::GateSimulator, "simulator", "the template supports the simulator"},
    {Gate::Placeholder, RejectionReason::GatePlaceholder, "placeholder",
     "every placeholder is bound to something in the knowledge base"},
    {Gate::Affordance, RejectionReason::GateAffordance, "affordance",
     "each category has the affordances of its placeholder"},
    {Gate::Constraint, RejectionReason::GateConstraint, "constraint", "the template's constraints on categories hold"},
    {Gate::StateOfCategory, RejectionReason::GateStateOfCategory, "state_of_category",
     "the goal uses only states that its categories have"},
    {Gate::ExclusiveStates, RejectionReason::GateExclusiveStates, "exclusive_states",
     "the goal never requires two exclusive states"},
    {Gate::OnePlace, RejectionReason::GateOnePlace, "one_place", "the goal never requires one object in two places"},
    {Gate::Capacity, RejectionReason::GateCapacity, "capacity", "the objects fit where the goal requires them"},
    {Gate::Counts, RejectionReason::GateCounts, "counts",
     "the goal never requires two different numbers of the same objects"},
    {Gate::Start, RejectionReason::GateStart, "start", "some start satisfies the start constraints"},
    {Gate::FalseAtStart, RejectionReason::GateFalseAtStart, "false_at_start",
     "each part of the goal is false in every start"},
    {Gate::Reachable, RejectionReason::GateReachable, "reachable",
     "the simulator's actions can make each part of the goal true"},
}};

const GateInfo& info(Gate gate) { return kGates[static_cast<std::size_t>(gate)]; }

}  // namespace

std::string_view name_of(Gate gate) { return info(gate).name; }
RejectionReason rejection_of(Gate gate) { return info(gate).reason; }
std::string_view meaning_of(Gate gate) { return info(gate).meaning; }

}  // namespace unietp
