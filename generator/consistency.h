#pragma once

#include <optional>
#include <string>

#include "akb/knowledge.h"
#include "generator/specification.h"

namespace unietp {

/// Why no end state can satisfy the goal, or nullopt when nothing speaks against it: one object asked to be in two
/// exclusive states or in two places at once, a state that its category does not have, a place that the knowledge base
/// does not allow or where fewer objects fit than are asked for, counts that exclude each other. Sound refusals only; a
/// goal that passes may still turn out to have no plan.
std::optional<std::string> contradiction(const Specification& specification, const Knowledge& knowledge);

/// A problem that shows on starts drawn at random from those that meet `init`: no start found at all, or one in which
/// a part of the goal (goal_parts) already holds; names the part. nullopt when `samples` starts are fine.
std::optional<std::string> bad_start(const Specification& specification, const Knowledge& knowledge, int samples);

}  // namespace unietp
