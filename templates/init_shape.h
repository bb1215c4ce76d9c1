#pragma once

#include <optional>
#include <string>
#include <vector>

#include "logic/formula.h"

namespace unietp {

/// Start constraints are enforced by construction, so they keep to shapes that grounding knows how to make true:
///
///   (exists (?x - D) body)   (forall (?x - D) body)   (count >= n (?x - D) body)   (count = n (?x - D) body)
///
/// where body is a literal, an `(and ...)` of literals, or `(and)`; and a literal is a state of ?x, `(not state)`,
/// `(exists (?y - E) (on ?x ?y))` or `(not (exists (?y - E) (on ?x ?y)))`, with inside, on_floor, in_room, next_to,
/// under or nearest in place of on; or, of a room ?x, `(in_room agent ?x)` or its `not`.
/// What is wrong with a formula, or nullopt when it has one of these shapes.
std::optional<std::string> init_shape_problem(const Formula& formula);

/// A literal of such a body: a state of the variable, or a relation of it to some object of a domain.
struct StartLiteral {
  bool positive = true;
  Predicate predicate = Predicate::Open;
  std::string symbol;  // of `filled`, `covered`, `colour`, …; else ""
  bool relation = false;
  Domain other;  // of a relation: what the second argument ranges over
  bool operator==(const StartLiteral&) const = default;
};
/// The literals of the body of a formula of such a shape, in order.
std::vector<StartLiteral> start_literals(const Formula& formula);

/// The least number of objects of its domain that satisfy the body when the formula holds: n for `count`, 1 for
/// `exists`, 0 for `forall`.
int demanded_count(const Formula& formula);

}  // namespace unietp
