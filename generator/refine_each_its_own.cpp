#include <algorithm>

#include "akb/attributes.h"
#include "generator/consistency.h"
#include "generator/reference.h"
#include "generator/refinement.h"
#include "scene/states.h"

namespace unietp {
namespace {

constexpr int kMostTried = 6;

const Formula& literal_of(const Formula& test) { return test.op == Formula::Op::Exists ? test.children.front() : test; }

/// The other of a pair of states: clean for dirty.
std::optional<Predicate> opposite(Predicate state) {
  for (const auto& group : state_groups()) {
    const auto& states = group.predicates;
    if (states.size() != 2 || std::find(states.begin(), states.end(), state) == states.end()) continue;
    return states[0] == state ? states[1] : states[0];
  }
  return std::nullopt;
}

/// A reference for the second variable that no object can pass together with the first; of the same kind, so that the
/// words set one against the other.
std::optional<Reference> set_against(const Reference& first, const std::vector<Reference>& offered,
                                     const std::string& variable) {
  const auto& one = literal_of(first.test);
  if (first.kind == Referring::ByState) {
    const auto other = opposite(one.predicate);
    if (!other) return std::nullopt;
    return Reference{first.kind, atom(*other, {variable}), {}};
  }
  for (const auto& candidate : offered) {
    const auto& other = literal_of(candidate.test);
    if (one.predicate != other.predicate || one == other) continue;
    if (first.kind == Referring::ByAttribute && !distinguishable(one.terms[1].name, other.terms[1].name)) continue;
    if (first.test.op == Formula::Op::Exists && first.test.domain == candidate.test.domain) continue;
    return candidate;
  }
  return std::nullopt;
}

/// The specification with the second variable's category replaced by the first's.
Specification merged(const Specification& plain, const GoalVariable& first, const GoalVariable& second) {
  auto changed = plain;
  const std::vector<NameBinding> names = {{second.category, {first.category}}};
  changed.goal = substitute_names(plain.goal, names);
  for (auto& start : changed.init) start = substitute_names(start, names);
  for (auto& [placeholder, category] : changed.binding) {
    if (category == second.category) category = first.category;
  }
  return changed;
}

}  // namespace

std::optional<Specification> refine_each_its_own(const Specification& plain, const Knowledge& knowledge,
                                                 const SceneOffer& offer, Rng rng) {
  auto variables = singular_variables(plain.goal);
  std::erase_if(variables, [&](const GoalVariable& variable) {
    const auto* category = knowledge.find(variable.category);
    return category == nullptr || !category->movable || !category->countable;
  });
  rng.shuffle(variables);
  if (variables.size() < 2 || variables[0].variable == variables[1].variable) return std::nullopt;
  const auto& first = variables[0];
  auto second = variables[1];
  const auto base = merged(plain, first, second);
  second.category = first.category;
  std::vector<Referring> kinds = {Referring::ByState, Referring::ByAttribute, Referring::BySize, Referring::ByRelation,
                                  Referring::ByRoom};
  rng.shuffle(kinds);
  int tried = 0;
  for (const auto kind : kinds) {
    const auto offered = references(kind, second, base, knowledge, offer, rng.fork(name_of(kind), 1));
    for (const auto& one : references(kind, first, base, knowledge, offer, rng.fork(name_of(kind), 0))) {
      const auto other = set_against(one, offered, second.variable);
      if (!other) continue;
      if (++tried > kMostTried) return std::nullopt;
      auto refined = base;
      auto domain = of_category(first.category);
      domain.where = {one.test};
      refined.goal = with_domain(refined.goal, first, domain);
      domain.where = {other->test};
      refined.goal = with_domain(refined.goal, second, domain);
      refined.split = Split::InstanceGrounding;
      refined.refinement = Referring::EachItsOwn;
      if (!demand_referents(refined, first, {one.test}, Comparison::Equal, 1)) continue;
      refined.init.push_back(counted(second, Comparison::Equal, 1, other->test));
      for (const auto& reference : {one, *other}) {
        for (const auto& start : reference.start) refined.init.push_back(start);
      }
      if (contradiction(refined, knowledge) || bad_start(refined, knowledge, kStartsDrawn)) continue;
      return refined;
    }
  }
  return std::nullopt;
}

}  // namespace unietp
