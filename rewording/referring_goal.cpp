#include "rewording/referring_goal.h"

#include <algorithm>

#include "generator/goal_variable.h"
#include "logic/evaluate.h"

namespace unietp {
namespace {

using P = Predicate;

/// What people say of a thing to tell it from others.
constexpr P kStates[] = {P::Dirty, P::Open, P::PowerOn, P::Hot, P::Cool, P::Sliced, P::Clean, P::Closed, P::PowerOff};
constexpr P kPlaces[] = {P::On, P::Inside, P::InRoom};

Formula at_place(P place, const std::string& variable, const std::string& category) {
  const std::string other = variable + "_at";
  return exists(other, of_category(category), atom(place, {variable, other}));
}

/// All that is plainly true of an entity in the start.
std::vector<Formula> descriptions(const Scene& start, const Trace& trace, EntityIndex entity,
                                  const std::string& variable) {
  std::vector<Formula> found;
  const Facts& facts = trace.states.front();
  for (const P state : kStates)
    if (facts.holds(state, entity)) found.push_back(atom(state, {variable}));
  for (const P place : kPlaces)
    for (EntityIndex other; other.index() < trace.entities.size(); ++other)
      if (facts.holds(place, entity, other)) found.push_back(at_place(place, variable, trace.entities[other].category));
  const auto node = std::find_if(start.nodes.begin(), start.nodes.end(),
                                 [&](const Node& one) { return one.id == trace.entities[entity].id; });
  if (node != start.nodes.end() && !node->color.empty())
    found.push_back(atom_with_symbol(P::Color, variable, node->color));
  return found;
}

}  // namespace

std::optional<Formula> referring_goal(const Formula& goal, const Scene& start, const Trace& trace, Rng rng) {
  auto variables = singular_variables(goal);
  rng.shuffle(variables);
  for (const GoalVariable& variable : variables) {
    const auto alike = members_of(of_category(variable.category), variable.variable, trace);
    const auto there = std::count_if(alike.begin(), alike.end(), [&](auto e) { return trace.states[0].exists(e); });
    if (there < 2) continue;
    for (const EntityIndex entity : alike) {
      auto all = descriptions(start, trace, entity, variable.variable);
      rng.shuffle(all);
      for (const Formula& where : all) {
        Domain domain = of_category(variable.category);
        domain.where = {where};
        if (members_of(domain, variable.variable, trace).size() != 1) continue;
        Formula described = with_domain(goal, variable, domain);
        if (holds(described, trace)) return described;
      }
    }
  }
  return std::nullopt;
}

}  // namespace unietp
