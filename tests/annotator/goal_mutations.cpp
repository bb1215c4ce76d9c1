#include "goal_mutations.h"

#include <algorithm>
#include <functional>

#include "annotator/meaning.h"

namespace unietp::testing_support {
namespace {

using Op = Formula::Op;
using P = Predicate;
using Change = std::function<bool(Formula&)>;

/// Applies a change at each place of a formula in turn, each time to a copy of the whole.
void everywhere(const Formula& whole, const Change& change, const std::function<void(Formula)>& take) {
  Formula here = whole;
  if (change(here)) take(std::move(here));
  for (std::size_t i = 0; i < whole.children.size(); ++i)
    everywhere(whole.children[i], change, [&](Formula child) {
      Formula copy = whole;
      copy.children[i] = std::move(child);
      take(std::move(copy));
    });
}

P other_state(P predicate) {
  switch (predicate) {
    case P::Open:
      return P::Closed;
    case P::Closed:
      return P::Open;
    case P::PowerOn:
      return P::PowerOff;
    case P::PowerOff:
      return P::PowerOn;
    case P::Clean:
      return P::Dirty;
    case P::Dirty:
      return P::Clean;
    case P::Hot:
      return P::Cool;
    case P::Cool:
      return P::Hot;
    case P::On:
      return P::Inside;
    case P::Inside:
      return P::On;
    default:
      return predicate;
  }
}

std::string fresh(const std::string& name) { return name + "x"; }

Formula renamed_apart(const Formula& f) {
  Formula result = f;
  if (!f.variable.empty()) {
    result.variable = fresh(f.variable);
    for (Formula& where : result.domain.where) where = rename_variable(where, f.variable, result.variable);
    for (Formula& child : result.children) child = rename_variable(child, f.variable, result.variable);
  }
  for (Formula& where : result.domain.where) where = renamed_apart(where);
  for (Formula& child : result.children) child = renamed_apart(child);
  return result;
}

}  // namespace

std::vector<WrongGoal> wrong_goals(const Formula& goal, const std::vector<std::string>& others, Rng rng) {
  std::vector<WrongGoal> found;
  const auto add = [&](const char* kind, const Change& change) {
    everywhere(goal, change, [&](Formula wrong) { found.push_back({kind, std::move(wrong)}); });
  };
  add("wrong object", [&](Formula& f) {
    if (f.domain.members.size() != 1 || others.empty()) return false;
    const std::string other = rng.pick(others);
    if (other == f.domain.members[0].category) return false;
    f.domain.members[0].category = other;
    return true;
  });
  add("wrong count", [](Formula& f) { return f.op == Op::Count ? (++f.number, true) : false; });
  add("missing count", [](Formula& f) {
    if (f.op != Op::Count || f.comparison == Comparison::AtMost || f.number < 2) return false;
    f.op = Op::Exists, f.comparison = Comparison::Equal, f.number = 0;
    return true;
  });
  add("missing count", [](Formula& f) {
    if (f.op != Op::Forall || f.children[0].op == Op::Not) return false;
    f.op = Op::Exists;
    return true;
  });
  add("swapped order", [](Formula& f) {
    if (f.op != Op::Before && f.op != Op::Until) return false;
    std::swap(f.children[0], f.children[1]);
    return true;
  });
  add("missing order", [](Formula& f) {
    if (f.op != Op::And) return false;
    const auto order = std::find_if(f.children.begin(), f.children.end(), [](auto& c) { return c.op == Op::Before; });
    if (order == f.children.end() || f.children.size() < 2) return false;
    f.children.erase(order);
    return true;
  });
  add("wrong state", [](Formula& f) {
    if (f.op != Op::Atom || other_state(f.predicate) == f.predicate) return false;
    f.predicate = other_state(f.predicate);
    return true;
  });
  add("missing part", [](Formula& f) {
    if (f.op != Op::And || f.children.size() < 2) return false;
    f.children.pop_back();
    return true;
  });
  add("extra demand", [](Formula& f) {
    if (f.op != Op::AtEnd || f.children[0].op != Op::Atom || f.children[0].terms[0].kind != Term::Kind::Variable)
      return false;
    const P extra = f.children[0].predicate == P::Clean ? P::Hot : P::Clean;
    f.children[0] = conjunction({f.children[0], atom(extra, {f.children[0].terms[0].name})});
    return true;
  });
  add("wrong referent", [](Formula& f) {
    if (f.domain.where.empty()) return false;
    f.domain.where.clear();
    return true;
  });
  add("wrong referent", [](Formula& f) {
    if (f.domain.where.empty() || f.domain.where[0].op != Op::Atom) return false;
    Formula& where = f.domain.where[0];
    if (other_state(where.predicate) == where.predicate || where.terms.size() > 1) return false;
    where.predicate = other_state(where.predicate);
    return true;
  });
  return found;
}

Formula rewritten(const Formula& goal, Rng& rng) {
  Formula f = renamed_apart(goal);
  const std::function<Formula(Formula)> turn = [&](Formula g) -> Formula {
    for (Formula& child : g.children) child = turn(std::move(child));
    if ((g.op == Op::And || g.op == Op::Or) && g.children.size() > 1 && rng.chance(0.7)) rng.shuffle(g.children);
    if (g.op == Op::Forall && rng.chance(0.6)) {
      g.op = Op::Exists;
      g.children[0] = negation(std::move(g.children[0]));
      return negation(std::move(g));
    }
    if (g.op == Op::Exists && rng.chance(0.3)) {
      g.op = Op::Count, g.comparison = Comparison::AtLeast, g.number = 1;
      return g;
    }
    if (g.op == Op::Count && g.comparison == Comparison::AtLeast && g.number > 0 && rng.chance(0.6)) {
      g.comparison = Comparison::Greater, --g.number;
      return g;
    }
    if (g.op == Op::Count && g.comparison == Comparison::Equal && rng.chance(0.6)) {
      Formula least = g, most = g;
      least.comparison = Comparison::AtLeast, most.comparison = Comparison::AtMost;
      return conjunction({least, most});
    }
    if (g.op == Op::Atom && (g.predicate == P::Closed || g.predicate == P::PowerOff) && rng.chance(0.3)) {
      g.predicate = g.predicate == P::Closed ? P::Open : P::PowerOn;
      return negation(std::move(g));
    }
    return g;
  };
  return turn(std::move(f));
}

}  // namespace unietp::testing_support
