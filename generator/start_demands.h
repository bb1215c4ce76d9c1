#pragma once

#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "generator/specification.h"
#include "symbolic/world.h"
#include "templates/init_shape.h"

namespace unietp {

/// What a specification asks of its starts, read once: how many things of which categories there are to be, in which
/// rooms, and the constraints that they have to meet.
struct StartDemands {
  struct Amount {
    symbolic::KindId kind;  // of the rules
    int least = 1, most = 2;
  };
  /// A start constraint.
  struct Aim {
    const Formula* formula = nullptr;
    std::vector<StartLiteral> literals;
    bool shaped = true;     // false: of no shape that says how to make it true
    bool of_agent = false;  // (in_room agent ?r)
    bool of_attributes = false;
  };

  /// The specification outlives the demands.
  StartDemands(const Specification& specification, const Knowledge& knowledge);

  symbolic::Rules rules;
  std::vector<Amount> amounts;
  std::vector<std::string> rooms;  // types that the specification names
  std::vector<Aim> aims;
  bool with_nearest = false;
};

}  // namespace unietp
