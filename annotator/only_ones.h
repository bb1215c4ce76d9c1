#pragma once

#include <span>
#include <string>

#include "logic/formula.h"

namespace unietp {

/// The goal with a name in place of each variable over a kind of which the home has one: "for every sink", "for some
/// sink" and "the sink" are the same there. Equal in truth on every trace of the home, whose kinds do not change.
/// `alone`: categories and room types of which the home has one, sorted.
Formula with_names_of_only_ones(const Formula& formula, std::span<const std::string> alone);

}  // namespace unietp
