#include <algorithm>
#include <stdexcept>

#include "reader.h"

namespace unietp::testing {

PddlMachine::PddlMachine(const PddlDomain& domain, const PddlProblem& problem)
    : domain_(domain), problem_(problem), state_(problem.init) {}

bool PddlMachine::is_of(const std::string& object, const std::string& type) const {
  for (auto own = problem_.objects.at(object); !own.empty(); own = domain_.types.at(own)) {
    if (own == type) return true;
  }
  return false;
}

PddlFact PddlMachine::ground(const PddlList& atom, const Scope& scope) const {
  PddlFact fact;
  for (const auto& part : atom.parts) {
    const auto bound = scope.find(part.word);
    fact.push_back(bound == scope.end() ? part.word : bound->second);
  }
  return fact;
}

template <class Use>
void PddlMachine::each(const std::vector<PddlVariable>& variables, std::size_t from, Scope& scope, Use use) const {
  if (from == variables.size()) return use();
  for (const auto& [object, type] : problem_.objects) {
    if (!is_of(object, variables[from].type)) continue;
    scope[variables[from].name] = object;
    each(variables, from + 1, scope, use);
  }
}

bool PddlMachine::holds(const PddlList& formula, const Scope& scope) const {
  const auto& head = formula.parts.at(0).word;
  if (head == "and" || head == "or") {
    for (std::size_t i = 1; i < formula.parts.size(); ++i) {
      if (holds(formula.parts[i], scope) != (head == "and")) return head == "or";
    }
    return head == "and";
  }
  if (head == "not") return !holds(formula.parts[1], scope);
  if (head == "forall") {
    bool all = true;
    auto inner = scope;
    each(pddl_variables(formula.parts[1], 0, true), 0, inner, [&] { all = all && holds(formula.parts[2], inner); });
    return all;
  }
  const auto fact = ground(formula, scope);
  if (head == "=") return fact[1] == fact[2];
  return state_.count(fact) > 0;
}

void PddlMachine::collect(const PddlList& effect, const Scope& scope, PddlState& comes, PddlState& goes) const {
  const auto& head = effect.parts.at(0).word;
  if (head == "and") {
    for (std::size_t i = 1; i < effect.parts.size(); ++i) collect(effect.parts[i], scope, comes, goes);
  } else if (head == "not") {
    goes.insert(ground(effect.parts[1], scope));
  } else if (head == "when") {
    if (holds(effect.parts[1], scope)) collect(effect.parts[2], scope, comes, goes);
  } else if (head == "forall") {
    auto inner = scope;
    each(pddl_variables(effect.parts[1], 0, true), 0, inner, [&] { collect(effect.parts[2], inner, comes, goes); });
  } else {
    comes.insert(ground(effect, scope));
  }
}

bool PddlMachine::perform(const PddlFact& step) {
  const auto action = domain_.actions.find(step.at(0));
  if (action == domain_.actions.end()) throw std::runtime_error("no action " + step[0]);
  const auto& parameters = action->second.parameters;
  if (parameters.size() + 1 != step.size()) throw std::runtime_error("wrong number of arguments of " + step[0]);
  Scope scope;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (problem_.objects.count(step[i + 1]) == 0) throw std::runtime_error("no object " + step[i + 1]);
    if (!is_of(step[i + 1], parameters[i].type)) throw std::runtime_error(step[i + 1] + " is no " + parameters[i].type);
    scope[parameters[i].name] = step[i + 1];
  }
  if (!holds(action->second.precondition, scope)) return false;
  PddlState comes, goes;
  collect(action->second.effect, scope, comes, goes);
  for (const auto& fact : goes) state_.erase(fact);
  state_.insert(comes.begin(), comes.end());
  return true;
}

bool PddlMachine::goal_holds() const { return holds(problem_.goal, {}); }

/// Whether the part of a conjunction that is bound already holds.
bool PddlMachine::may_hold(const PddlList& formula, const Scope& scope) const {
  for (const auto& part : formula.parts) {
    if (part.is_word()) continue;
    const auto& atom = part.parts[0].word == "not" ? part.parts[1] : part;
    bool bound = true;
    for (std::size_t i = 1; i < atom.parts.size(); ++i)
      bound = bound && (atom.parts[i].word[0] != '?' || scope.count(atom.parts[i].word) > 0);
    if (bound && !holds(part, scope)) return false;
  }
  return true;
}

void PddlMachine::possible_from(const std::string& name, const PddlAction& action, Scope& scope, PddlFact& step,
                                std::vector<PddlFact>& found) const {
  if (!may_hold(action.precondition, scope)) return;
  if (step.size() == action.parameters.size() + 1) {
    found.push_back(step);
    return;
  }
  const auto& parameter = action.parameters[step.size() - 1];
  for (const auto& [object, type] : problem_.objects) {
    if (!is_of(object, parameter.type)) continue;
    scope[parameter.name] = object;
    step.push_back(object);
    possible_from(name, action, scope, step, found);
    step.pop_back();
    scope.erase(parameter.name);
  }
}

std::vector<PddlFact> PddlMachine::possible() const {
  std::vector<PddlFact> found;
  for (const auto& [name, action] : domain_.actions) {
    Scope scope;
    PddlFact step{name};
    possible_from(name, action, scope, step, found);
  }
  return found;
}

bool reaches_goal(const PddlDomain& domain, const PddlProblem& problem, const std::vector<PddlFact>& plan) {
  PddlMachine machine(domain, problem);
  return std::ranges::all_of(plan, [&](const auto& step) { return machine.perform(step); }) && machine.goal_holds();
}

std::string needless_step(const PddlDomain& domain, const PddlProblem& problem, const std::vector<PddlFact>& plan) {
  const auto of_monitor = [&](std::size_t i) { return plan[i][0] == "note" || plan[i][0] == "judge"; };
  for (std::size_t i = 0; i < plan.size(); ++i) {
    if (of_monitor(i)) continue;
    std::size_t next = i + 1;
    while (next < plan.size() && of_monitor(next)) ++next;
    auto without = plan;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(i),
                  without.begin() + static_cast<std::ptrdiff_t>(next));
    if (!reaches_goal(domain, problem, without)) continue;
    std::string text = std::to_string(i + 1) + ":";
    for (const auto& word : plan[i]) text += " " + word;
    return text;
  }
  return "";
}

int shortest_pddl_plan(const PddlDomain& domain, const PddlProblem& problem, int most) {
  PddlMachine machine(domain, problem);
  std::set<PddlState> seen{problem.init};
  std::vector<PddlState> layer{problem.init};
  for (int length = 0; length <= most && !layer.empty(); ++length) {
    std::vector<PddlState> next;
    for (const auto& state : layer) {
      machine.reset(state);
      if (machine.goal_holds()) return length;
      for (const auto& step : machine.possible()) {
        machine.reset(state);
        machine.perform(step);
        if (seen.insert(machine.state()).second) next.push_back(machine.state());
      }
    }
    layer = std::move(next);
  }
  return -1;
}

}  // namespace unietp::testing
