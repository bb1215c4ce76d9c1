#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "akb/knowledge.h"
#include "core/rng.h"
#include "generator/specification.h"
#include "symbolic/goal.h"
#include "symbolic/world.h"

namespace unietp {

struct NaiveScene {
  symbolic::Setting setting;
  symbolic::World start;
};

/// Random symbolic scenes that meet a specification's `init`, by blind trial: states and places are drawn at random,
/// and one of an object that a broken constraint ranges over is drawn again until all hold. Several objects of each
/// category, two that the goal does not speak of, and places to put all that moves aside. What lies where something is
/// done to it by itself (in a freezer, under power) is as that leaves it. Shares no code with StartSampler.
class NaiveScenes {
 public:
  NaiveScenes(const Specification& specification, const Knowledge& knowledge, Rng rng,
              ActionProfile profile = ActionProfile::Unietp);
  std::optional<NaiveScene> draw(Rng rng) const;

 private:
  friend class NaiveDraw;
  /// One of `init`, read once.
  struct Constraint {
    const Formula* formula = nullptr;
    std::vector<Formula> atoms;
    std::vector<symbolic::KindId> kinds;  // that it speaks of
  };
  const Specification& specification_;
  std::vector<Constraint> constraints_;
  std::vector<std::string> categories_, room_types_;
  std::vector<symbolic::SubstanceId> coats_;
  std::size_t named_ = 0;      // the first so many categories are the specification's
  std::vector<int> limits_;    // by category: no more than fit, where the goal is about all of them
  std::vector<int> demanded_;  // by category: objects that some constraint asks for
  std::vector<std::pair<symbolic::KindId, symbolic::KindId>>
      visited_;  // a category that the goal wants beside one that cannot be carried
  symbolic::Rules rules_;
  bool with_nearest_ = false;
};

}  // namespace unietp
