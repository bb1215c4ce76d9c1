#pragma once

#include <optional>

#include "akb/knowledge.h"
#include "core/rng.h"
#include "generator/specification.h"
#include "generator/start_demands.h"
#include "generator/symbolic_start.h"

namespace unietp {

/// Draws small symbolic starts that satisfy a specification's `init`: a few objects of each category that it or its
/// goal speaks of, in random states that their affordances give them and at random places that the knowledge base
/// allows; an agent with empty hands, in a room that the specification does not speak of unless `init` wants it
/// otherwise. What `init` asks for is set, what breaks it is changed until all holds.
class StartSampler {
 public:
  /// The specification outlives the sampler.
  StartSampler(const Specification& specification, const Knowledge& knowledge) : demands_(specification, knowledge) {}

  /// nullopt when no start was found within the budget of repairs. Deterministic in rng.
  std::optional<SymbolicStart> sample(Rng rng) const;

 private:
  StartDemands demands_;
};

}  // namespace unietp
