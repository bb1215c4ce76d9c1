#pragma once

#include <string>
#include <vector>

#include "generator/specification.h"
#include "scene/start.h"

namespace unietp {

/// A specification grounded in a scene whose start has been checked from physics alone.
struct Episode {
  Specification specification;
  std::string layout;              // id of the base scene
  Delta changes;                   // from the base scene to the start
  Scene start;                     // start_in(base scene, changes): at rest, edges read
  std::vector<std::string> edits;  // what was changed to meet the start, for people: "added Mug mug_4 on CounterTop_1"
};

/// Why a candidate was given up: a counted outcome, not an error. `stage` and `reason` come from closed lists.
struct Rejection {
  std::string stage;   // generator, grounding, expert, annotator, validator
  std::string reason;  // kebab-case: "no-free-place", "start-not-met", "goal-holds-at-start", "not-reachable", …
  std::string detail;  // a sentence with template, categories and, for a placement, what it hit
};

}  // namespace unietp
