#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "akb/knowledge.h"
#include "core/rng.h"
#include "generator/specification.h"
#include "logic/trace.h"

namespace unietp {

/// Draws small symbolic starts, without any geometry, that satisfy a specification's `init`: a few objects of each
/// category it speaks of, in random states that their affordances give them and at random places that the knowledge
/// base allows. Used to find goals that are already true before a scene is built.
class StartSampler {
 public:
  StartSampler(const Specification& specification, const Knowledge& knowledge);

  /// A trace of one state; nullopt when no start was found within the budget of repairs. Deterministic in rng.
  std::optional<Trace> sample(Rng rng) const;

 private:
  struct Place {
    Predicate relation;
    std::size_t receptacle;  // position in World::objects
  };
  struct Object {
    std::size_t kind;                // position in kinds_
    std::vector<std::size_t> value;  // of each of its state groups: position in the group
    std::optional<Place> place;
    std::size_t room = 0;  // position in rooms_, or their number for some other room
  };
  struct Kind {
    std::string category;
    std::vector<std::size_t> groups;  // positions in state_groups() of the groups that the category has
    int least = 1, most = 2;          // how many objects of it a start has
  };
  using World = std::vector<Object>;

  World random_world(Rng& rng) const;
  std::vector<Place> places_for(const World& world, std::size_t object) const;
  void randomise(World& world, std::size_t object, const Formula& aim, Rng& rng) const;
  Trace trace_of(const World& world) const;
  std::vector<std::size_t> broken(const World& world) const;  // positions in init

  const Specification& specification_;
  const Knowledge& knowledge_;
  std::vector<Kind> kinds_;
  std::vector<std::string> rooms_;
};

}  // namespace unietp
