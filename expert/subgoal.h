#pragma once

#include <compare>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "expert/situation.h"
#include "logic/evaluate.h"

namespace unietp {

/// One truth to bring about or, with `positive` false, to take away.
struct Literal {
  Predicate predicate = Predicate::Open;
  EntityIndex subject = kNobody, object = kNobody;
  std::string symbol;
  bool positive = true;
  auto operator<=>(const Literal&) const = default;
};
/// For messages: "not inside(mug_1, fridge_1)".
std::string to_text(const Literal& literal, const Situation& situation);

/// Literals that have to hold together at one position of the trace.
struct Moment {
  std::vector<Literal> literals;   // sorted
  std::vector<std::size_t> after;  // moments that must have come earlier
};

/// A state formula that must hold at every position up to a moment (with the moment's own position when `inclusive`),
/// or always.
struct MaintenanceGoal {
  static constexpr std::size_t kAlways = static_cast<std::size_t>(-1);
  Formula formula;
  Assignment assignment;
  std::size_t until = kAlways;
  bool inclusive = false;
};

/// Literals that hold at the start, sorted; those that something holds, and those that it does not.
struct LiteralSets {
  std::vector<Literal> yes, no;
  bool operator==(const LiteralSets&) const = default;
};
/// Sorted and split by `positive`.
LiteralSets literal_sets(std::vector<Literal> literals);
/// What holds in both.
LiteralSets together(const LiteralSets& a, const LiteralSets& b);

/// One way to meet a goal: every choice of witness, branch and number is made; only the order is open.
struct Alternative {
  std::vector<Literal> end;  // sorted; not yet true at the start
  /// What holds at the start and must still hold at the end, nullptr for nothing. "None of them on any of those" is
  /// thousands of truths, which the ways to meet the rest of a goal have in common.
  std::shared_ptr<const LiteralSets> standing;
  std::vector<Moment> moments;
  std::vector<MaintenanceGoal> maintained;
  double cost = 0;  // estimated actions, plus a little for the way
};
/// Its moments and what it wants of the end: tells the alternatives of one goal apart.
std::string to_text(const Alternative& alternative, const Situation& situation);
/// The same without what holds at the start.
std::string changes_text(const Alternative& alternative, const Situation& situation);
/// All that an alternative wants of the end, sorted.
std::vector<Literal> wanted_at_end(const Alternative& alternative);

/// Whether the literal is true in a state.
bool holds_in(const Literal& literal, const Facts& facts);
/// Can never hold together: opposite truths, two states of one group, one thing in two places, more held than hands.
bool clash(const Literal& a, const Literal& b, const Situation& situation);
/// A truth to bring about that cannot hold together with some of those.
bool clash(const Literal& change, const LiteralSets& standing, const Situation& situation);
}  // namespace unietp
