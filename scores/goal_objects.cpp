#include "scores/goal_objects.h"

#include <algorithm>

#include "logic/evaluate.h"

namespace unietp {
namespace {

void collect(const Formula& formula, const Trace& start, std::vector<GoalObjects>& found) {
  using Op = Formula::Op;
  const bool binds =
      formula.op == Op::Exists || formula.op == Op::Forall || formula.op == Op::Count || formula.op == Op::Number;
  if (binds && formula.domain.kind == Domain::Kind::Categories) {
    std::vector<std::string> outer;
    if (!formula.domain.where.empty()) outer = free_variables(formula.domain.where.front());
    std::erase(outer, formula.variable);
    if (outer.empty()) {
      GoalObjects objects;
      for (const EntityIndex entity : members_of(formula.domain, formula.variable, start)) {
        if (start.entities[entity].kind == Entity::Kind::Object) objects.referents.insert(start.entities[entity].id);
      }
      Domain whole = formula.domain;
      whole.where.clear();
      for (const EntityIndex entity : members_of(whole, formula.variable, start)) {
        const Entity& one = start.entities[entity];
        if (one.kind == Entity::Kind::Object && !objects.referents.contains(one.id)) objects.alike.insert(one.id);
      }
      if (!objects.referents.empty()) found.push_back(std::move(objects));
    }
  }
  for (const Formula& child : formula.children) collect(child, start, found);
}

}  // namespace

std::vector<GoalObjects> goal_objects(const Formula& goal, const Trace& start) {
  std::vector<GoalObjects> found;
  collect(goal, start, found);
  return found;
}

std::vector<GoalObjects> goal_objects(const EnvironmentTask& task) {
  return goal_objects(task.goal, Trace{task.reader.entities(), {task.facts}});
}

}  // namespace unietp
