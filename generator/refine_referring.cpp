#include <algorithm>
#include <array>

#include "generator/consistency.h"
#include "generator/domain_constraints.h"
#include "generator/goal_variable.h"
#include "generator/specification.h"
#include "scene/states.h"
#include "templates/init_shape.h"

namespace unietp {
namespace {

using Op = Formula::Op;

constexpr int kStarts = 6;

/// States that tell one object from another at a glance and stay as they are until the agent changes them.
constexpr std::array kTellingStates = {Predicate::Open,   Predicate::PowerOn, Predicate::Dirty, Predicate::Hot,
                                       Predicate::Cool,   Predicate::Cooked,  Predicate::Burnt, Predicate::Frozen,
                                       Predicate::Soaked, Predicate::Folded};

/// VirtualHome and Habitat keep few states; a task must not refer to one that the simulator cannot show.
bool shows(Simulator simulator, Predicate state) {
  if (simulator == Simulator::Habitat) return state == Predicate::Open;
  if (simulator == Simulator::Virtualhome) return state == Predicate::Open || state == Predicate::PowerOn;
  return true;
}

struct Reference {
  GoalVariable variable;
  Formula where;  // with the variable free
  std::string name;
};

bool in_group(const StateGroup& group, Predicate predicate) {
  return std::find(group.predicates.begin(), group.predicates.end(), predicate) != group.predicates.end();
}

bool concerns(const Formula& start, const std::string& category) {
  return std::any_of(start.domain.members.begin(), start.domain.members.end(),
                     [&](const Domain::Member& member) { return !member.slice && member.category == category; });
}

/// A group of states is free when neither the goal nor the start speaks of it for this category.
bool is_free(const StateGroup& group, const GoalVariable& variable, const Specification& plain) {
  for (const auto predicate : predicates_of(plain.goal, variable.variable)) {
    if (in_group(group, predicate)) return false;
  }
  return std::none_of(plain.init.begin(), plain.init.end(), [&](const Formula& start) {
    if (!concerns(start, variable.category)) return false;
    const auto literals = start_literals(start);
    return std::any_of(literals.begin(), literals.end(),
                       [&](const StartLiteral& l) { return in_group(group, l.predicate); });
  });
}

std::vector<Reference> by_state(const Specification& plain, const Knowledge& knowledge) {
  std::vector<Reference> found;
  for (const auto& variable : singular_variables(plain.goal)) {
    for (const auto& group : state_groups()) {
      if (!knowledge.has(variable.category, group.affordance) || !is_free(group, variable, plain)) continue;
      for (const auto state : kTellingStates) {
        if (!in_group(group, state) || !shows(plain.simulator, state)) continue;
        found.push_back({variable, atom(state, {variable.variable}), "by-state"});
      }
    }
  }
  return found;
}

std::string fresh_variable(const Specification& plain) {
  auto taken = bound_variables(plain.goal);
  for (const auto& start : plain.init) {
    for (auto& name : bound_variables(start)) taken.push_back(std::move(name));
  }
  std::string name = "p";
  for (int i = 2; std::find(taken.begin(), taken.end(), name) != taken.end(); ++i)
    name = std::string("p").append(std::to_string(i));
  return name;
}

bool start_needs_place(const Specification& plain, const std::string& category) {
  return std::any_of(plain.init.begin(), plain.init.end(), [&](const Formula& start) {
    if (!concerns(start, category)) return false;
    const auto literals = start_literals(start);
    return std::any_of(literals.begin(), literals.end(),
                       [](const StartLiteral& l) { return l.positive && l.relation; });
  });
}

/// One place a movable object is likely to be found at, drawn by how likely it is; none that the task speaks of, so
/// that nobody has to guess whether the place or the target is meant.
std::vector<Reference> by_place(const Specification& plain, const Knowledge& knowledge, Rng rng) {
  std::vector<Reference> found;
  auto named = categories_of(plain.goal);
  for (const auto& [placeholder, category] : plain.binding) named.push_back(category);
  const auto place_variable = fresh_variable(plain);
  for (const auto& variable : singular_variables(plain.goal)) {
    const auto* category = knowledge.find(variable.category);
    if (category == nullptr || !category->movable || start_needs_place(plain, variable.category)) continue;
    std::vector<std::pair<Predicate, const Placement*>> places;
    std::vector<double> weights;
    for (const auto relation : {Predicate::On, Predicate::Inside}) {
      for (const auto* row : knowledge.placements_of(variable.category, info(relation).name)) {
        const auto* receptacle = knowledge.find(row->receptacle);
        const bool taken = std::find(named.begin(), named.end(), row->receptacle) != named.end();
        if (receptacle == nullptr || receptacle->movable || taken || row->likelihood <= 0) continue;
        places.emplace_back(relation, row);
        weights.push_back(row->likelihood);
      }
    }
    if (places.empty()) continue;
    const auto& [relation, row] = places[rng.weighted(weights)];
    found.push_back(
        {variable,
         exists(place_variable, of_category(row->receptacle), atom(relation, {variable.variable, place_variable})),
         "by-place"});
  }
  return found;
}

/// Exactly one object that the reference picks out and at least one that it excludes. What is thereby implied goes;
/// what says that there is just one object leaves no room for a distractor.
bool demand_distractor(Specification& refined, const Reference& reference) {
  const auto& [variable, category] = reference.variable;
  std::vector<Formula> kept;
  for (auto& start : refined.init) {
    const bool bare =
        demanded_count(start) >= 1 && start.domain == of_category(category) && start_literals(start).empty();
    if (bare && start.op == Op::Count && start.comparison == Comparison::Equal && start.number < 2) return false;
    if (bare && start.comparison != Comparison::Equal && demanded_count(start) <= 2) continue;
    if (bare && start.op == Op::Exists) continue;
    kept.push_back(std::move(start));
  }
  Formula one;
  one.op = Op::Count;
  one.comparison = Comparison::Equal;
  one.number = 1;
  one.variable = variable;
  one.domain = of_category(category);
  one.children = {reference.where};
  Formula others = one;
  others.comparison = Comparison::AtLeast;
  others.children = {negation(reference.where)};
  kept.push_back(std::move(one));
  kept.push_back(std::move(others));
  refined.init = std::move(kept);
  return true;
}

std::optional<Specification> refined_by(const Specification& plain, const Knowledge& knowledge,
                                        const Reference& reference) {
  auto refined = plain;
  auto domain = of_category(reference.variable.category);
  domain.where = {reference.where};
  refined.goal = with_domain(plain.goal, reference.variable.variable, domain);
  refined.split = Split::InstanceGrounding;
  refined.refinement = reference.name;
  if (!demand_distractor(refined, reference)) return std::nullopt;
  if (contradiction(refined, knowledge) || bad_start(refined, knowledge, kStarts)) return std::nullopt;
  return refined;
}

}  // namespace

std::optional<Specification> refine_referring(const Specification& plain, const Knowledge& knowledge, Rng rng) {
  if (!plain.refinement.empty()) return std::nullopt;
  std::vector<std::vector<Reference>> kinds = {by_state(plain, knowledge),
                                               by_place(plain, knowledge, rng.fork("place", 0))};
  rng.shuffle(kinds);
  for (auto& references : kinds) rng.shuffle(references);
  // Movable objects first: a scene can be given one more of them as distractor, seldom one more fridge.
  for (const bool movable : {true, false}) {
    for (const auto& references : kinds) {
      for (const auto& reference : references) {
        const auto* category = knowledge.find(reference.variable.category);
        if (category == nullptr || category->movable != movable) continue;
        if (auto refined = refined_by(plain, knowledge, reference)) return refined;
      }
    }
  }
  return std::nullopt;
}

}  // namespace unietp
