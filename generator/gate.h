#pragma once

#include <string>
#include <string_view>

#include "generator/rejection.h"

namespace unietp {

/// What a candidate, a template with a binding on a simulator, has to pass before any scene is built; in this order.
enum class Gate {
  Simulator,        // the template claims the simulator
  Placeholder,      // every placeholder is bound, to something that the knowledge base knows
  Affordance,       // each category is what its placeholder asks for
  Constraint,       // the template's domain constraints hold
  StateOfCategory,  // the goal asks for states that its categories have
  ExclusiveStates,  // never for two states of one group of one object, or for a thing and its opposite
  OnePlace,         // never for one object in two places
  Capacity,         // never for more objects in a place than fit there, nor for a place that is not allowed
  Counts,           // never for two numbers of the same thing
  Start,            // some start meets `init`
  FalseAtStart,     // each part of the goal is false in the starts that meet `init`
  Reachable,        // actions that the simulator offers can make each part of the goal true
};
/// "exclusive_states"
std::string_view name_of(Gate gate);
/// The reason of a candidate's rejection.
RejectionReason rejection_of(Gate gate);
/// What the gate asks for, in one line for people.
std::string_view meaning_of(Gate gate);

/// Why a candidate is not proposed.
struct GateRefusal {
  Gate gate = Gate::Simulator;
  std::string about;   // the constraint, literal or part of the goal that decided, as text; else the name at fault
  std::string reason;  // what is wrong
  std::string remedy;  // what would have to change: the binding, a fact of the knowledge base or the template
  bool operator==(const GateRefusal&) const = default;
};

}  // namespace unietp
