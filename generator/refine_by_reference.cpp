#include <algorithm>

#include "generator/consistency.h"
#include "generator/goal_variable.h"
#include "generator/reference.h"
#include "generator/refinement.h"
#include "scene/states.h"

namespace unietp {
namespace {

using Op = Formula::Op;

constexpr std::size_t kMostReferencesTried = 6;

/// What a style refers by. "The kitchen cabinet" needs a room, "the red one" a word before the noun.
std::vector<Referring> kinds_for(Style style) {
  switch (style) {
    case Style::Compound:
      return {Referring::ByRoom};
    case Style::Ellipsis:
      return {Referring::ByState, Referring::ByAttribute};
    case Style::Anaphora:
      return {Referring::ByState, Referring::ByAttribute, Referring::ByRelation, Referring::ByRoom};
    case Style::Exception:
      return {Referring::ByState, Referring::ByAttribute};
    default:
      return {Referring::ByState, Referring::ByRelation};
  }
}

std::vector<Reference> offered(Style style, const GoalVariable& variable, const Specification& plain,
                               const Knowledge& knowledge, const SceneOffer& offer, Rng rng) {
  std::vector<Reference> all;
  for (const Referring kind : kinds_for(style))
    for (auto& reference : references(kind, variable, plain, knowledge, offer, rng.fork(name_of(kind), 0)))
      all.push_back(std::move(reference));
  // "The mug that is not on the desk", but not "that is not next to a bowl", "not on any of the desks", or "not dirty",
  // which is clean.
  if (style == Style::Negation)
    std::erase_if(all, [&](const Reference& one) {
      if (one.kind == Referring::ByState) return opposite_of(one.test.predicate).has_value();
      return one.kind == Referring::ByRelation && (one.test.children.front().predicate == Predicate::NextTo ||
                                                   number_of(offer, one.test.domain.members.front().category) > 1);
    });
  rng.shuffle(all);
  if (all.size() > kMostReferencesTried) all.resize(kMostReferencesTried);
  return all;
}

void add_start(Specification& refined, const Reference& reference) {
  for (const auto& start : reference.start)
    if (std::find(refined.init.begin(), refined.init.end(), start) == refined.init.end()) refined.init.push_back(start);
}

/// The one thing that passes the test is meant, and others are there that do not.
std::optional<Specification> meaning_one(const Specification& plain, const GoalVariable& variable,
                                         const Reference& reference, bool denied) {
  auto refined = plain;
  const Formula test = denied ? negation(reference.test) : reference.test;
  const Formula other = denied ? reference.test : negation(reference.test);
  auto domain = of_category(variable.category);
  domain.where = {test};
  refined.goal = with_domain(plain.goal, variable, domain);
  if (!demand_referents(refined, variable, {test}, Comparison::Equal, 1)) return std::nullopt;
  refined.init.push_back(counted(variable, Comparison::AtLeast, denied ? 2 : 1, other));
  add_start(refined, reference);
  return refined;
}

/// All but the one that passes the test, which is never to be so.
Formula excepting(const Formula& goal, const GoalVariable& variable, const Formula& test) {
  Formula changed = goal;
  if (goal.op == Op::Forall && goal.variable == variable.variable && goal.children[0].op == Op::AtEnd) {
    changed.domain.where = {negation(test)};
    auto left = of_category(variable.category);
    left.where = {test};
    Formula never;
    never.op = Op::Always;
    never.children = {forall(variable.variable, left, negation(goal.children[0].children[0]))};
    return conjunction({std::move(changed), std::move(never)});
  }
  for (Formula& child : changed.children) child = excepting(child, variable, test);
  return changed;
}

std::optional<Specification> all_but_one(const Specification& plain, const GoalVariable& variable,
                                         const Reference& reference) {
  auto refined = plain;
  refined.goal = excepting(plain.goal, variable, reference.test);
  if (refined.goal == plain.goal) return std::nullopt;
  if (!demand_referents(refined, variable, {negation(reference.test)}, Comparison::AtLeast, 2)) return std::nullopt;
  refined.init.push_back(counted(variable, Comparison::Equal, 1, reference.test));
  add_start(refined, reference);
  return refined;
}

}  // namespace

std::optional<Specification> refine_by_reference(const Specification& plain, const Knowledge& knowledge,
                                                 const SceneOffer& offer, Style style, Rng rng) {
  const bool exception = style == Style::Exception;
  auto variables = exception ? counted_variables(plain.goal) : singular_variables(plain.goal);
  std::erase_if(variables, [&](const GoalVariable& variable) {
    const auto* category = knowledge.find(variable.category);
    if (category == nullptr || !category->countable) return true;
    if (exception && variable.quantifier != Op::Forall) return true;
    return category->movable == (style == Style::Compound);
  });
  rng.shuffle(variables);
  for (const auto& variable : variables) {
    for (const auto& reference : offered(style, variable, plain, knowledge, offer, rng.fork(variable.variable, 0))) {
      auto refined = exception ? all_but_one(plain, variable, reference)
                               : meaning_one(plain, variable, reference, style == Style::Negation);
      if (!refined) continue;
      refined->split = Split::Linguistic;
      refined->style = style;
      refined->refinement = reference.kind;
      if (contradiction(*refined, knowledge) || bad_start(*refined, knowledge, kStartsDrawn)) continue;
      return refined;
    }
  }
  return std::nullopt;
}

}  // namespace unietp
