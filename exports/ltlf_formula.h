#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/result.h"
#include "logic/formula.h"
#include "logic/trace.h"

namespace unietp {

/// An atom of a grounded goal, under a name that tools for temporal logic accept: `[a-z][a-z0-9_]*`.
struct LtlfProposition {
  std::string name;                    // "on_mug_1_table_2"
  std::string predicate;               // "on"
  std::vector<std::string> arguments;  // ids of objects and rooms, "agent", or a word such as "water"
  /// Whether it holds in a state of a trace that begins with the start that the goal was grounded in.
  bool holds_in(const Facts& facts) const;
  bool presence = false;  // that the first argument exists, of which no predicate tells
  Predicate meaning = Predicate::Open;
  std::vector<EntityIndex> entities;  // of the arguments; a word has none
};

/// A grounded goal with the propositions that it is about.
struct LtlfGoal {
  std::string formula;                        // with ! & | F G U, true and false
  std::vector<LtlfProposition> propositions;  // in order of name; those that the formula names
};

/// A goal as a propositional formula of linear temporal logic on finite traces: every quantifier and count is written
/// out over the objects of the start. `start`: a trace of the start state, with comparisons; entities that exist only
/// in further states of it may come later and then stay, and a quantifier ranges over those that come. No `next` and no
/// `last` is used, since tools differ in these: "f at the end" is G(F(f)). Equal goals and starts give equal text.
/// Errors: Unsatisfiable with the reason, where the goal ranges over objects that the start does not have yet, or the
/// formula would be longer than 100,000 characters.
Result<LtlfGoal> ltlf_goal(const Formula& goal, const Trace& start);

}  // namespace unietp
