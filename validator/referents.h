#pragma once

#include <map>
#include <string>
#include <vector>

#include "logic/formula.h"
#include "logic/trace.h"
#include "scene/scene.h"
#include "simulation/profile.h"

namespace unietp {

/// What a goal means by a phrase such as "the mug nearest to the sink".
struct Referents {
  std::string phrase;              // the domain's text
  std::string kind;                // "nearness", "relation+state": what its tests are about, sorted
  std::vector<std::string> means;  // ids
  /// Of these, those that are not, on foot within one room, what the phrase says: nearest to the thing, by the margins
  /// of `nearest` and among all of that room, or in the room of the thing that they are next to.
  std::vector<std::string> beyond_wall;
  /// Ids of others of the category that would be taken for the nearest on foot.
  std::vector<std::string> rivals;
  /// Tests without which the phrase would mean the same: nothing else passes all but this one. None of a condition ("if
  /// the dishwasher is open"), which tells from nothing.
  std::vector<std::string> idle;
  /// Tests of a relation ("on the table", "next to the sink") for which no other thing of the category has the wrong
  /// relation: those of which it is not true stand in no relation of that kind to anything.
  std::vector<std::string> unrelated;
};
/// Of every domain of the goal that selects by facts of the start. `start`: the first state of this trace.
std::vector<Referents> referents_of(const Formula& goal, const Scene& scene, const Trace& start,
                                    const Profile& profile);

/// How many referents a data set has, and how many are amiss.
struct ReferentCounts {
  int phrases = 0, referents = 0;
  std::map<std::string, int> by_kind;  // referents
  int beyond_wall = 0;                 // referents
  int rivals = 0;                      // phrases that somebody on foot would take otherwise
  int without_alternative = 0;         // referents of phrases with a test that tells them from nothing
  int without_relation = 0;            // referents of phrases with a relation that no alternative has to anything
  void add(const Referents& one);
  void add(const ReferentCounts& more);
};

}  // namespace unietp
