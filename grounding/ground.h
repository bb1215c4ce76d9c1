#pragma once

#include <variant>

#include "akb/knowledge.h"
#include "core/rng.h"
#include "generator/rejection.h"
#include "grounding/episode.h"
#include "grounding/home.h"
#include "grounding/household.h"
#include "simulation/known_start.h"
#include "simulation/profile.h"

namespace unietp {

/// Budgets of the search for a start.
struct GroundingOptions {
  int draws_per_object = 60;             // poses tried for one placement
  int rounds = 4;                        // passes over the start constraints before giving up
  bool likely = false;                   // a start that no home looks like is rejected (odd_start of ground.cpp)
  bool natural = false;                  // and one in which nobody would refer to things so (StartGates::natural)
  bool dangerous = false;                // but something may be where safety forbids it
  const Household* household = nullptr;  // how things are in such homes; nullptr: as the knowledge base says
  bool decoys = false;                   // things are added besides those that the task needs (decoys.h)
  bool pictured = false;                 // what the goal needs has to show clearly in a picture from somewhere
};

/// An episode, with what is known of its start already.
struct Grounded {
  Episode episode;
  KnownStart known;
};

/// Stage: (specification, home, rng) → episode. Edits a copy of the home's scene until every start constraint holds and
/// the goal does not, then checks the result using only physics: constraints hold, each conjunct of the goal is false,
/// what the goal names can be reached by the body, a referring constraint picks out what it should and leaves a
/// distractor. Deterministic. Budgets are tries, never time.
std::variant<Grounded, Rejection> ground(const Specification& specification, const Home& home,
                                         const Knowledge& knowledge, const Profile& profile,
                                         const GroundingOptions& options, Rng rng);

}  // namespace unietp
