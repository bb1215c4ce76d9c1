#include "generator/start_demands.h"

#include <algorithm>
#include <set>

namespace unietp {
namespace {

bool speaks_of(const Domain& domain, const std::string& category) {
  return std::any_of(domain.members.begin(), domain.members.end(),
                     [&](const Domain::Member& member) { return !member.slice && member.category == category; });
}

bool speaks_of_agent(const Formula& formula) {
  return std::any_of(formula.terms.begin(), formula.terms.end(),
                     [](const Term& term) { return term.kind == Term::Kind::Agent; }) ||
         std::any_of(formula.children.begin(), formula.children.end(), speaks_of_agent);
}

bool speaks_of_attributes(const Formula& formula) {
  const auto& p = formula.predicate;
  if (formula.op == Formula::Op::Atom) return p == Predicate::Color || p == Predicate::Material || p == Predicate::Size;
  return std::any_of(formula.children.begin(), formula.children.end(), speaks_of_attributes) ||
         std::any_of(formula.domain.where.begin(), formula.domain.where.end(), speaks_of_attributes);
}

/// Whether the formula speaks of a state or relation that only actions of the profile `wide` bring about.
bool asks_for_wide(const Formula& formula) {
  if (formula.op == Formula::Op::Atom) {
    const auto action = direct_action(formula.predicate);
    if (formula.predicate == Predicate::Attached || (action && is_extension(*action))) return true;
  }
  return std::any_of(formula.children.begin(), formula.children.end(), asks_for_wide);
}

symbolic::Capabilities offer_for(const Specification& specification, Simulator simulator) {
  return symbolic::capabilities_of(simulator,
                                   asks_for_wide(specification.goal) ? ActionProfile::Wide : ActionProfile::Unietp);
}

std::vector<std::string> names_in(const Specification& specification) {
  std::set<std::string> names;
  for (auto& name : categories_of(specification.goal)) names.insert(std::move(name));
  for (const auto& start : specification.init) {
    for (auto& name : categories_of(start)) names.insert(std::move(name));
  }
  return {names.begin(), names.end()};
}

/// Substances that a formula names, and whether it asks what is nearest.
void read_words(const Formula& formula, symbolic::Rules& rules, bool& nearest) {
  if (formula.op == Formula::Op::Atom) {
    nearest = nearest || formula.predicate == Predicate::Nearest;
    const bool substance = formula.predicate == Predicate::Filled || formula.predicate == Predicate::Covered;
    if (substance && formula.terms.size() == 2 && formula.terms[1].name != "any")
      rules.symbol_number(formula.terms[1].name);
  }
  for (const auto& where : formula.domain.where) read_words(where, rules, nearest);
  for (const auto& child : formula.children) read_words(child, rules, nearest);
}

/// Whether no object can serve both constraints, since they ask for opposites.
bool exclude(const std::vector<StartLiteral>& one, const std::vector<StartLiteral>& other) {
  return std::any_of(one.begin(), one.end(), [&](StartLiteral literal) {
    literal.positive = !literal.positive;
    return std::find(other.begin(), other.end(), literal) != other.end();
  });
}

}  // namespace

StartDemands::StartDemands(const Specification& specification, const Knowledge& knowledge)
    : rules(knowledge, offer_for(specification, knowledge.simulator()), names_in(specification)) {
  read_words(specification.goal, rules, with_nearest);
  for (const auto& start : specification.init) {
    read_words(start, rules, with_nearest);
    const bool shaped = !init_shape_problem(start);
    auto literals = shaped ? start_literals(start) : std::vector<StartLiteral>{};
    aims.push_back({&start, std::move(literals), shaped, speaks_of_agent(start), speaks_of_attributes(start)});
  }
  if (rules.symbols().empty()) rules.symbol_number("water");  // for what is full of something
  for (const auto& name : names_in(specification)) {
    const auto kind = rules.kind_named(name);
    if (!kind) {
      rooms.push_back(name);
      continue;
    }
    Amount amount{*kind, 1, 2};
    int sum = 0;
    bool exact = false;
    for (const auto& aim : aims) {
      if (!speaks_of(aim.formula->domain, name)) continue;
      const int demanded = demanded_count(*aim.formula);
      amount.least = std::max(amount.least, demanded);
      for (const auto& other : aims) {
        const bool both = other.shaped && demanded > 0 && demanded_count(*other.formula) > 0;
        if (both && speaks_of(other.formula->domain, name) && exclude(aim.literals, other.literals))
          amount.least = std::max(amount.least, demanded + demanded_count(*other.formula));
      }
      sum += demanded;
      exact = exact || (aim.formula->op == Formula::Op::Count && aim.formula->comparison == Comparison::Equal &&
                        aim.literals.empty());
    }
    amount.most = exact ? amount.least : std::max(amount.least, sum) + 1;
    amounts.push_back(amount);
  }
}

}  // namespace unietp
