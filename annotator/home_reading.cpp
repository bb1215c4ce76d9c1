#include "annotator/home_reading.h"

#include <algorithm>

#include "generator/consistency.h"
#include "logic/evaluate.h"

namespace unietp {
namespace {

bool is_closed(const Domain& domain, const std::string& variable) {
  if (domain.where.empty()) return true;
  const auto free = free_variables(domain.where[0]);
  return std::all_of(free.begin(), free.end(), [&](const std::string& name) { return name == variable; });
}

/// Whether a domain is of what the start has; what slicing makes comes later.
bool is_there(const Domain& domain, const std::string& variable, const Trace& start) {
  if (domain.kind != Domain::Kind::Categories || domain.members.empty() || !is_closed(domain, variable)) return true;
  const bool slices = std::any_of(domain.members.begin(), domain.members.end(), [](const auto& m) { return m.slice; });
  return slices || !members_of(domain, variable, start).empty();
}

/// Of alternatives one is enough: of "if the box is open, …, if not, …" the start has but one.
bool all_there(const Formula& formula, const Trace& start) {
  if (!is_there(formula.domain, formula.variable, start)) return false;
  const auto there = [&](const Formula& child) { return all_there(child, start); };
  return formula.op == Formula::Op::Or ? std::any_of(formula.children.begin(), formula.children.end(), there)
                                       : std::all_of(formula.children.begin(), formula.children.end(), there);
}

/// "Put a mug in it", where "it" would be the mug.
bool relates_to_itself(const Formula& formula) {
  if (formula.op == Formula::Op::Atom && formula.terms.size() == 2 && formula.terms[0] == formula.terms[1]) return true;
  return std::any_of(formula.children.begin(), formula.children.end(), relates_to_itself);
}

/// Which is not taken for so of a home that is not known.
bool says_there_is_none(const Formula& fact) { return fact.op == Formula::Op::Forall; }

bool is_plausible(const Reading& reading, const Knowledge& knowledge, const Trace* start) {
  Specification asked;
  asked.simulator = knowledge.simulator();
  asked.goal = reading.goal;
  if (relates_to_itself(reading.goal) || contradiction(asked, knowledge)) return false;
  return (start == nullptr || all_there(reading.goal, *start)) && facts_hold(reading, start);
}

}  // namespace

bool facts_hold(const Reading& reading, const Trace* start) {
  return std::all_of(reading.facts.begin(), reading.facts.end(), [&](const Formula& fact) {
    return start == nullptr ? !says_there_is_none(fact) : holds_in(fact, *start, 0);
  });
}

std::vector<Reading> readings_in_home(std::vector<Reading> readings, const Knowledge& knowledge, const Trace* start) {
  std::erase_if(readings, [&](const Reading& reading) { return !is_plausible(reading, knowledge, start); });
  return readings;
}

}  // namespace unietp
