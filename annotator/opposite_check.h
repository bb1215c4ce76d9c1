#pragma once

#include <string>
#include <vector>

#include "annotator/noun_table.h"
#include "generator/specification.h"

namespace unietp {

/// What a text says the other way around, though it has all words of the goal: "turn off" for "turn on", "take it off"
/// for "put it on", "none of the" for "both", "at most" for "at least", "all" for "a", "the smaller" for "the larger",
/// "and" for "or", and the later of two things first. Worded for a writer; empty when there is nothing. `words`: the
/// tokens of the text. What it cannot tell, as the order of two things in a text without words of order, it lets pass:
/// reading back decides. Deterministic.
std::vector<std::string> opposite_faults(const std::vector<Token>& words, const Specification& specification);

}  // namespace unietp
