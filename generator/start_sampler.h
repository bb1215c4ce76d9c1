#pragma once

#include <optional>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "core/rng.h"
#include "generator/specification.h"
#include "symbolic/world.h"
#include "templates/init_shape.h"

namespace unietp {

/// A start without any geometry. The setting points to the rules of the sampler that drew it.
struct SymbolicStart {
  symbolic::Setting setting;
  symbolic::World world;
};

/// Draws small symbolic starts that satisfy a specification's `init`: a few objects of each category that it or its
/// goal speaks of, in random states that their affordances give them and at random places that the knowledge base
/// allows; an agent with empty hands, in a room that the specification does not speak of unless `init` wants it
/// otherwise. What `init` asks for is set, what breaks it is changed until all holds.
class StartSampler {
 public:
  /// The specification outlives the sampler.
  StartSampler(const Specification& specification, const Knowledge& knowledge);

  /// nullopt when no start was found within the budget of repairs. Deterministic in rng.
  std::optional<SymbolicStart> sample(Rng rng) const;

 private:
  friend class StartDraft;
  struct Amount {
    symbolic::KindId kind;  // of rules_
    int least = 1, most = 2;
  };
  /// A start constraint, read once.
  struct Aim {
    const Formula* formula = nullptr;
    std::vector<StartLiteral> literals;
    bool shaped = true;     // false: of no shape that says how to make it true
    bool of_agent = false;  // (in_room agent ?r)
    bool of_attributes = false;
  };

  symbolic::Rules rules_;
  std::vector<Amount> amounts_;
  std::vector<std::string> rooms_;  // types that the specification names
  std::vector<Aim> aims_;
  bool with_nearest_ = false;
};

}  // namespace unietp
