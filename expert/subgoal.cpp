#include "expert/subgoal.h"

#include <algorithm>
#include <iterator>

#include "core/sort_unique.h"

namespace unietp {
namespace {

bool at_one_place_only(Predicate predicate) {
  return predicate == Predicate::On || predicate == Predicate::Inside || predicate == Predicate::OnFloor ||
         predicate == Predicate::Held;
}

/// Two places that one thing can have together: a shelf inside a cabinet inside a room, a plate in a fridge.
bool places_agree(const Literal& a, const Literal& b, const Facts& facts) {
  if (a.predicate != b.predicate) {
    return a.predicate != Predicate::Held && b.predicate != Predicate::Held && a.predicate != Predicate::OnFloor &&
           b.predicate != Predicate::OnFloor;
  }
  return a.predicate == Predicate::Inside &&
         (facts.holds(Predicate::Inside, a.object, b.object) || facts.holds(Predicate::Inside, b.object, a.object));
}

bool exclude_each_other(Predicate a, Predicate b) {
  if (a == b) return false;
  for (const StateGroup& group : state_groups()) {
    const auto has = [&group](Predicate p) {
      return std::find(group.predicates.begin(), group.predicates.end(), p) != group.predicates.end();
    };
    if (has(a) && has(b)) return true;
  }
  return false;
}

std::string text_of(const std::vector<Literal>& literals, const Situation& situation) {
  std::string text;
  for (const Literal& literal : literals) text += to_text(literal, situation) + "; ";
  return text;
}

std::string text_of_moments(const Alternative& alternative, const Situation& situation) {
  std::string text;
  for (const Moment& moment : alternative.moments) text += text_of(moment.literals, situation) + "then ";
  return text;
}

}  // namespace

std::string to_text(const Literal& literal, const Situation& situation) {
  std::string text(info(literal.predicate).name);
  text += "(" + situation.entity(literal.subject).id;
  if (literal.object != kNobody) text += ", " + situation.entity(literal.object).id;
  if (!literal.symbol.empty()) text += ", " + literal.symbol;
  return (literal.positive ? "" : "not ") + text + ")";
}

LiteralSets literal_sets(std::vector<Literal> literals) {
  sort_unique(literals);
  LiteralSets standing;
  for (Literal& literal : literals) (literal.positive ? standing.yes : standing.no).push_back(std::move(literal));
  return standing;
}

LiteralSets together(const LiteralSets& a, const LiteralSets& b) {
  LiteralSets all;
  std::set_union(a.yes.begin(), a.yes.end(), b.yes.begin(), b.yes.end(), std::back_inserter(all.yes));
  std::set_union(a.no.begin(), a.no.end(), b.no.begin(), b.no.end(), std::back_inserter(all.no));
  return all;
}

std::vector<Literal> wanted_at_end(const Alternative& alternative) {
  std::vector<Literal> wanted = alternative.end;
  if (alternative.standing) {
    for (const auto* part : {&alternative.standing->yes, &alternative.standing->no})
      wanted.insert(wanted.end(), part->begin(), part->end());
  }
  std::sort(wanted.begin(), wanted.end());
  return wanted;
}

std::string changes_text(const Alternative& alternative, const Situation& situation) {
  return text_of_moments(alternative, situation) + text_of(alternative.end, situation);
}

std::string to_text(const Alternative& alternative, const Situation& situation) {
  return text_of_moments(alternative, situation) + text_of(wanted_at_end(alternative), situation);
}

bool holds_in(const Literal& literal, const Facts& facts) {
  bool value = false;
  if (!literal.symbol.empty()) {
    value = facts.holds(literal.predicate, literal.subject, literal.symbol);
  } else if (literal.object != kNobody) {
    value = facts.holds(literal.predicate, literal.subject, literal.object);
  } else {
    value = facts.holds(literal.predicate, literal.subject);
  }
  return value == literal.positive;
}

bool clash(const Literal& a, const Literal& b, const Situation& situation) {
  if (a.positive != b.positive) {
    Literal opposite = b;
    opposite.positive = a.positive;
    return a == opposite;
  }
  if (!a.positive) return false;
  if (a.subject != b.subject) {
    if (a.predicate == Predicate::Held && b.predicate == Predicate::Held) return situation.profile.hands < 2;
    return a.object == b.subject && b.object == a.subject && a.object != kNobody && at_one_place_only(a.predicate) &&
           at_one_place_only(b.predicate);
  }
  if (at_one_place_only(a.predicate) && at_one_place_only(b.predicate)) {
    return a != b && !places_agree(a, b, situation.facts());
  }
  if (a.predicate == b.predicate && !a.symbol.empty()) return a.symbol != b.symbol && a.predicate == Predicate::Filled;
  return exclude_each_other(a.predicate, b.predicate);
}

bool clash(const Literal& change, const LiteralSets& standing, const Situation& situation) {
  Literal opposite = change;
  opposite.positive = !change.positive;
  const auto& contrary = opposite.positive ? standing.yes : standing.no;
  if (std::binary_search(contrary.begin(), contrary.end(), opposite)) return true;
  return change.positive && std::any_of(standing.yes.begin(), standing.yes.end(),
                                        [&](const Literal& truth) { return clash(change, truth, situation); });
}

}  // namespace unietp
