#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "logic/formula.h"
#include "logic/trace.h"

namespace unietp::monitoring {

/// Position of a node in Program::nodes.
using NodeId = std::uint32_t;
/// Number of a quantifier's variable: a position in Program::quantifiers.
using Slot = std::uint32_t;

/// A comparison of a weighted sum of truths with zero; closed under negation, which `Comparison` is not.
enum class Relation : std::uint8_t { Equal, Unequal, AtLeast, AtMost, Greater, Less };
/// Whether `value relation 0` holds.
bool compare_with_zero(Relation relation, int value);

/// The variable of one quantifier: what it ranges over.
struct Quantifier {
  Domain domain;
  bool first_state_only = false;  // it has a `:where`: its members are fixed by the first state
  std::string words;              // what messages call a member: "Mug"
};

/// A goal in negation normal form: negation stands only at atoms, `imply`, `before` and the two counts are rewritten,
/// `:where` has become a guard that is read in the first state.
struct Node {
  enum class Kind : std::uint8_t {
    True,
    False,
    Atom,
    Same,
    And,
    Or,
    Forall,
    Exists,
    Sum,
    AtEnd,
    Sometime,
    Always,
    Until,
    Release,
    Guard,
  };
  struct Argument {
    enum class Kind : std::uint8_t { None, Variable, Agent, Symbol };
    Kind kind = Kind::None;
    Slot slot = 0;
    std::string symbol;
  };
  /// weight * (how many members satisfy the body)
  struct Summand {
    int weight = 1;
    Slot slot = 0;
    NodeId body = 0;  // conjoined with the guard
  };

  Kind kind = Kind::True;
  bool positive = true;  // of Atom and Same
  Predicate predicate = Predicate::Open;
  Argument arguments[2];
  Slot slot = 0;                 // of Forall and Exists
  std::vector<NodeId> children;  // Guard: the state formula to read in the first state
  Relation relation = Relation::Equal;
  int constant = 0;  // Sum: constant + summands `relation` 0
  std::vector<Summand> summands;
  std::vector<Slot> free;  // its free variables, sorted
};

/// A goal as a monitor reads it.
struct Program {
  std::vector<Node> nodes;
  std::vector<Quantifier> quantifiers;  // by slot: every quantifier of the goal has a variable of its own
  NodeId root = 0;
};

/// The goal has no free variables.
Program compile(const Formula& goal);

}  // namespace unietp::monitoring
