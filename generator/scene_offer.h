#pragma once

#include <string>
#include <vector>

#include "logic/formula.h"
#include "logic/trace.h"

namespace unietp {

class PlaceUses;

/// What a home offers a task: categories to fill placeholders with, and what there is to refer by.
struct SceneOffer {
  std::vector<std::string> categories;  // that it has or may be given, and its room types; sorted; empty: any
  Trace now;                            // its present state, sizes and nearness among it; no state: nothing is known
  const PlaceUses* uses = nullptr;      // what its places are used for, which outlives this; null: nothing is known
};

/// How many objects or rooms of a domain the home has now; those of its `:where`, when it has one. 0 when nothing is
/// known.
int number_in(const SceneOffer& offer, const Domain& domain, const std::string& variable);
/// The same for a category or a room type.
int number_of(const SceneOffer& offer, const std::string& category);

/// Types of room of which the home has exactly one: "the kitchen" says which. Sorted.
std::vector<std::string> single_rooms(const SceneOffer& offer);
/// Categories of which the home has exactly one object. Sorted.
std::vector<std::string> single_objects(const SceneOffer& offer);

}  // namespace unietp
