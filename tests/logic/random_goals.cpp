#include "random_goals.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace unietp::testing {
namespace {

using Op = Formula::Op;

Formula with_children(Op op, std::vector<Formula> children) {
  Formula result;
  result.op = op;
  result.children = std::move(children);
  return result;
}

Term variable(std::string name) { return {Term::Kind::Variable, std::move(name)}; }

}  // namespace

std::string GoalWriter::some_variable(bool room) {
  std::vector<std::string> fitting;
  for (const auto& known : scope_) {
    if (known.kind == Domain::Kind::Agent) continue;
    if ((known.kind == Domain::Kind::Room) == room) fitting.push_back(known.name);
  }
  return fitting.empty() ? "" : rng_.pick(fitting);
}

Formula GoalWriter::leaf(bool predicates) {
  const std::string x = some_variable(false), y = some_variable(false), room = some_variable(true);
  if (!predicates || x.empty()) {
    if (!x.empty() && rng_.chance(0.5)) {
      Formula same;
      same.op = Op::Equal;
      same.terms = {variable(x), variable(y)};
      return same;
    }
    if (predicates && !room.empty()) {
      Formula here = atom(Predicate::InRoom, {"agent", room});
      here.terms[0].kind = Term::Kind::Agent;
      return here;
    }
    return with_children(rng_.chance(0.5) ? Op::And : Op::Or, {});
  }
  switch (rng_.below(8)) {
    case 0:
      return atom(Predicate::Open, {x});
    case 1:
    case 2:
      return atom(Predicate::Hot, {x});
    case 3:
      return atom_with_symbol(Predicate::Filled, x, rng_.chance(0.5) ? "water" : "any");
    case 4:
    case 5:
      return atom(Predicate::On, {x, y});
    case 6:
      if (!room.empty()) return atom(Predicate::InRoom, {x, room});
      return atom(Predicate::Open, {y});
    default: {
      Formula same;
      same.op = Op::Equal;
      same.terms = {variable(x), variable(y)};
      return same;
    }
  }
}

Domain GoalWriter::domain(const std::string& name, bool with_where) {
  Domain result;
  switch (rng_.below(9)) {
    case 0:
      result.kind = Domain::Kind::Object;
      break;
    case 1:
      result.kind = Domain::Kind::Room;
      break;
    case 2:
      result.members = {{"A", false}, {"B", false}};
      break;
    case 3:
    case 4:
      result.members = {{"A", true}};
      break;
    case 5:
      result.members = {{"B", false}};
      break;
    case 6:
      result.members = {{"B", false}, {"A", true}};
      break;
    default:
      result.members = {{"A", false}};
      break;
  }
  if (with_where && rng_.chance(0.25)) {
    scope_.push_back({name, result.kind});
    result.where.push_back(formula(static_cast<int>(rng_.below(3)), true, false));
    scope_.pop_back();
  }
  return result;
}

Formula GoalWriter::quantified(Op op, int depth, bool predicates, bool temporal) {
  const bool where_is_open = temporal;  // inside a `:where` or a state formula none is allowed
  Formula result;
  result.op = op;
  result.variable = 'x';
  result.variable += std::to_string(names_++);
  result.domain = domain(result.variable, where_is_open);
  scope_.push_back({result.variable, result.domain.kind});
  result.children.push_back(formula(depth - 1, predicates, temporal));
  scope_.pop_back();
  return result;
}

Formula GoalWriter::formula(int depth, bool predicates, bool temporal) {
  if (depth <= 0) {
    if (predicates || !temporal) return leaf(predicates);
    return with_children(rng_.chance(0.5) ? Op::AtEnd : Op::Sometime, {leaf(true)});
  }
  const auto below = [&](bool with_predicates) { return formula(depth - 1, with_predicates, temporal); };
  const std::uint64_t kinds = temporal ? 18 : 11;
  switch (rng_.below(kinds)) {
    case 0:
      return with_children(Op::And, {below(predicates), below(predicates)});
    case 1:
      return with_children(Op::Or, {below(predicates), below(predicates)});
    case 2:
      return with_children(Op::Not, {below(predicates)});
    case 3:
      return with_children(Op::Imply, {below(predicates), below(predicates)});
    case 4:
    case 5:
      return quantified(Op::Forall, depth, predicates, temporal);
    case 6:
    case 7:
    case 8:
      return quantified(Op::Exists, depth, predicates, temporal);
    case 9: {
      Formula result = quantified(Op::Count, depth, predicates, temporal);
      result.comparison = static_cast<Comparison>(rng_.below(5));
      result.number = static_cast<int>(rng_.below(3));
      return result;
    }
    case 10: {
      Formula result = with_children(Op::CountCompare, {});
      result.comparison = static_cast<Comparison>(rng_.below(5));
      for (int side = 0; side < 2; ++side) {
        result.children.push_back(quantified(Op::Number, depth, predicates, temporal));
      }
      return result;
    }
    case 11:
      return with_children(Op::AtEnd, {below(true)});
    case 12:
    case 13:
      return with_children(Op::Sometime, {below(true)});
    case 14:
      return with_children(Op::Always, {below(true)});
    case 15:
      return with_children(Op::Until, {below(true), below(true)});
    default:
      return with_children(Op::Before, {below(true), below(true)});
  }
}

Formula goal_of(std::string_view text) {
  auto parsed = parse_formula("test", text, FormulaUse::Goal);
  EXPECT_TRUE(parsed) << format(parsed.error()) << text;
  return parsed ? *parsed : Formula{};
}

Trace random_trace(Rng rng) {
  struct Life {
    Entity entity;
    std::size_t from, to;
  };
  const std::size_t length = 1 + rng.below(5);
  const auto born = [&] { return static_cast<std::size_t>(rng.below(length + 1)); };
  const auto died = [&](std::size_t from) { return rng.chance(0.3) ? from + 1 + rng.below(length) : length; };
  using Kind = Entity::Kind;
  std::vector<Life> lives = {{{Kind::Agent, "agent", "agent", ""}, 0, length},
                             {{Kind::Room, "kitchen_1", "Kitchen", ""}, 0, length},
                             {{Kind::Object, "a_1", "A", ""}, 0, died(0)},
                             {{Kind::Object, "b_1", "B", ""}, 0, died(0)}};
  if (rng.chance(0.5)) lives.push_back({{Kind::Object, "a_2", "A", ""}, 0, died(0)});
  for (const char* id : {"slice_1", "slice_2"}) {
    const std::size_t from = born();
    lives.push_back({{Kind::Object, id, "ASliced", "A"}, from, died(from)});
  }
  const std::size_t late = born();
  lives.push_back({{Kind::Object, "b_2", "B", ""}, late, died(late)});
  std::erase_if(lives, [&](const Life& life) { return life.from >= length; });
  std::stable_sort(lives.begin(), lives.end(), [](const Life& a, const Life& b) { return a.from < b.from; });
  Trace trace;
  for (const auto& life : lives) trace.entities.push_back(life.entity);
  const double density = rng.uniform(0.2, 0.8);
  for (std::size_t i = 0; i < length; ++i) {
    Facts facts;
    for (EntityIndex e; e.index() < lives.size(); ++e) {
      const Life& life = lives[e.index()];
      if (life.from <= i && i < life.to) facts.set_exists(e);
    }
    for (EntityIndex e; e.index() < lives.size(); ++e) {  // also of what does not exist: must not count
      const auto kind = lives[e.index()].entity.kind;
      if (kind == Kind::Agent && rng.chance(density)) facts.set(Predicate::InRoom, e, EntityIndex(1));
      if (kind != Kind::Object) continue;
      if (rng.chance(density)) facts.set(Predicate::Open, e);
      if (rng.chance(density)) facts.set(Predicate::Hot, e);
      if (rng.chance(density)) facts.set(Predicate::Filled, e, rng.chance(0.5) ? "water" : "milk");
      if (rng.chance(density)) facts.set(Predicate::InRoom, e, EntityIndex(1));
      for (EntityIndex other(2); other.index() < lives.size(); ++other) {
        if (rng.chance(density / 2)) facts.set(Predicate::On, e, other);
      }
    }
    trace.states.push_back(std::move(facts));
  }
  return trace;
}

Trace prefix_of(const Trace& trace, std::size_t states) {
  Trace result;
  result.states.assign(trace.states.begin(), trace.states.begin() + static_cast<std::ptrdiff_t>(states));
  std::size_t met = 0;
  for (EntityIndex e; e.index() < trace.entities.size(); ++e) {
    for (const auto& facts : result.states) {
      if (facts.exists(e)) met = std::max<std::size_t>(met, e.index() + 1);
    }
  }
  for (EntityIndex e; e.index() < met; ++e) result.entities.push_back(trace.entities[e]);
  return result;
}

}  // namespace unietp::testing
