#pragma once

#include <optional>

#include "akb/knowledge.h"
#include "generator/gate.h"
#include "generator/specification.h"

namespace unietp {

/// Why no end state can satisfy the goal, or nullopt when nothing speaks against it: one object asked to be in two
/// exclusive states or in two places at once, a state that its category does not have, a place that the knowledge base
/// does not allow or where fewer objects fit than are asked for, counts that exclude each other. Sound refusals only; a
/// goal that passes may still turn out to have no plan.
std::optional<GateRefusal> contradiction(const Specification& specification, const Knowledge& knowledge);

/// A problem that shows on starts drawn at random from those that meet `init`: no start found at all, one in which the
/// goal or a part of it (goal_parts) already holds, or one from which the simulator's actions cannot make the goal true
/// even if nothing that was once true were lost. nullopt when `samples` starts are fine.
std::optional<GateRefusal> bad_start(const Specification& specification, const Knowledge& knowledge, int samples);

}  // namespace unietp
