#pragma once

#include <optional>
#include <string>
#include <vector>

#include "logic/formula.h"

namespace unietp {

/// One thing that a goal asks for.
struct Want {
  Predicate predicate = Predicate::On;
  std::size_t thing = 0;             // in Wants::things
  std::optional<std::size_t> other;  // of a relation: in Wants::things
  std::string symbol;                // of a state with one: "water"
  bool negated = false;              // it is to end: no dust on it
  bool operator==(const Want&) const = default;
};

/// What a goal asks for, in its order: of `first this, then that` the first comes first.
struct Wants {
  std::vector<Domain> things;  // what the goal's variables range over
  std::vector<bool> single;    // of each of these: the goal asks for one of them, not for all or for several
  std::vector<Want> wants;     // each once
  std::vector<Want> found;   // what a `:where` says of things before the task: where they are, near what, whether clean
  bool moves_agent = false;  // the agent itself is to be somewhere
};

/// Reads what must come about from a goal. What a goal only forbids, keeps as it is, assumes, or says to tell its
/// objects apart (`:where`) is not asked for.
Wants wants_of(const Formula& goal);

}  // namespace unietp
