#pragma once

#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "core/rng.h"
#include "generator/goal_variable.h"
#include "generator/scene_offer.h"
#include "generator/specification.h"

namespace unietp {

/// A property that distinguishes some objects of a category from the others at the start.
struct Reference {
  Referring kind = Referring::ByState;
  Formula test;                // of the goal's variable, which is free in it; a literal of templates/init_shape.h
  std::vector<Formula> start;  // what the start needs besides, so that the words have one meaning
};

/// The references of one kind (ByState, ByRelation, ByRoom, ByNearness, BySize, ByAttribute; none of another) that
/// knowledge and home offer for a variable of the goal. Left out is what goal and start speak of already, so that
/// nobody has to guess which is meant; for what cannot be moved, all that does not hold in the home as it is. Where
/// nothing is known of a home, all that the knowledge base allows. Deterministic in rng.
std::vector<Reference> references(Referring kind, const GoalVariable& variable, const Specification& plain,
                                  const Knowledge& knowledge, const SceneOffer& offer, Rng rng);

/// Of places and rooms only: the part of `references` that relates the variable to something else.
std::vector<Reference> references_to_others(Referring kind, const GoalVariable& variable, const Specification& plain,
                                            const Knowledge& knowledge, const SceneOffer& offer, Rng rng);

/// Whether a start constraint of the specification is about the category.
bool concerns(const Formula& start, const std::string& category);

/// How many objects of the variable's category the test picks out in the home, and how many it leaves.
struct Picked {
  int in = 0, out = 0;
};
/// Both 0 when nothing is known of the home.
Picked picked_by(const Formula& test, const GoalVariable& variable, const SceneOffer& offer);

}  // namespace unietp
