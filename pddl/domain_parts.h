#pragma once

#include <string>
#include <vector>

namespace unietp::pddl {

/// A predicate: "(fits-on ?x - movable ?y - thing)".
struct PredicateText {
  std::string name, arguments;
};

/// An action: its parts in PDDL, without the keywords around them.
struct ActionText {
  std::string name, parameters;
  std::vector<std::string> needs, effects;
};

}  // namespace unietp::pddl
