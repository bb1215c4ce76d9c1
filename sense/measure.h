#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "sense/common_sense.h"
#include "sense/items.h"

namespace unietp {

/// How many items got each grade, in the order of kGrades.
using GradeCounts = std::array<int, 3>;

/// An item with its grade, for reading.
struct GradedItem {
  Evidence evidence;
  Grade grade = Grade::Tolerable;
};

/// Figures of the items of one source that were held out of fitting.
struct HeldOutFigures {
  std::string source;
  GradeCounts real{};     // as they are
  GradeCounts against{};  // votes that speak against a place: at least 6 of 10 say implausible
  GradeCounts moved{};    // one role swapped for another thing, or another place, that is physically possible
  GradeCounts real_beside{}, moved_beside{};  // the same beside the other parts of their activities, where it has any
  GradeCounts listed{};  // the same, but only for what the knowledge base lists: its placements and affordances
  std::vector<GradedItem> items, swapped;  // of `real`; of `moved`
};

/// True for items that are held out: a quarter of the activities and objects, and a third of the titles of programs, by
/// the hash of source and group, so that nothing of an activity is on both sides.
bool is_held_out(const Item& item);

/// The judgments but those of a thing in a role that a held-out item is about: they were written with these items at
/// hand.
Judgments without_held_out(Judgments judgments, std::span<const Item> items);

/// Fits the counts to the items that are not held out and grades the others. `physical` is the knowledge base that
/// swaps are drawn from: half of the swaps of a placement put another kind of thing at the place, half put the thing
/// elsewhere, wherever it fits by size and shape; swaps of what is done draw another kind of thing that can be carried,
/// or, for what needs a part (a door, a switch, a hollow), one that has it. Kinds are drawn evenly, by hash.
///
/// Beside the other parts of its activity, an item that is usual by itself is tolerable when one of its kinds is rarer
/// among the kinds of the other parts than in all activities (Companions::among below 1; counted on what is not held
/// out). A swapped item stands beside what the other parts of the real activity speak of.
std::vector<HeldOutFigures> measure_held_out(std::span<const Item> items, const Kinds& kinds,
                                             const CategoryKinds& categories, const Judgments& judgments,
                                             const std::vector<SenseRule>& rules, const Knowledge& physical);

}  // namespace unietp
