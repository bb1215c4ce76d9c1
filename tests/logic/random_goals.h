#pragma once

#include <string>
#include <vector>

#include "core/rng.h"
#include "logic/formula.h"
#include "logic/trace.h"

namespace unietp::testing {

/// Random goals with everything the language has: nested temporal operators, counts, `:where`, slices, outer variables.
class GoalWriter {
 public:
  explicit GoalWriter(Rng rng) : rng_(rng) {}
  Formula goal() { return formula(3 + static_cast<int>(rng_.below(2)), false, true); }
  Formula state_formula(int depth) { return formula(depth, true, false); }

 private:
  struct Variable {
    std::string name;
    Domain::Kind kind;
  };

  Formula formula(int depth, bool predicates, bool temporal);
  Formula leaf(bool predicates);
  Formula quantified(Formula::Op op, int depth, bool predicates, bool temporal);
  Domain domain(const std::string& variable, bool with_where);
  std::string some_variable(bool room);

  Rng rng_;
  std::vector<Variable> scope_;
  int names_ = 0;
};

/// The goal that a text says; a test that gives another text fails.
Formula goal_of(std::string_view text);

/// Small traces whose objects appear (slices) and vanish midway. Entities are listed in the order of their appearance.
Trace random_trace(Rng rng);

/// The first `states` states, with the entities met in them.
Trace prefix_of(const Trace& trace, std::size_t states);

}  // namespace unietp::testing
