#include "expert/subgoal.h"

#include <algorithm>
#include <iterator>

#include "core/sort_unique.h"
#include "expert/ways.h"

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

void insert_once(std::vector<EntityIndex>& list, EntityIndex entity) {
  if (entity != kNobody && std::find(list.begin(), list.end(), entity) == list.end()) list.push_back(entity);
}

double metres_between(const Situation& situation, EntityIndex a, EntityIndex b) {
  const Node* from = situation.node(a);
  const Node* to = b == kNobody ? nullptr : situation.node(b);
  if (from == nullptr || to == nullptr) return 0;
  return (from->pose.position - to->pose.position).head<2>().norm();
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

bool has(const std::vector<Literal>& sorted, const Literal& literal) {
  return std::binary_search(sorted.begin(), sorted.end(), literal);
}

/// At the end or at one of its moments.
bool wants(const Alternative& alternative, const Literal& literal) {
  const auto& standing = alternative.standing;
  return has(alternative.end, literal) || (standing && has(literal.positive ? standing->yes : standing->no, literal)) ||
         std::any_of(alternative.moments.begin(), alternative.moments.end(),
                     [&](const Moment& moment) { return has(moment.literals, literal); });
}

constexpr double kActionsPerMetre = 0.1;

}  // namespace

std::string to_text(const Literal& literal, const Situation& situation) {
  std::string text(info(literal.predicate).name);
  text += "(" + situation.entity(literal.subject).id;
  if (literal.object != kNobody) text += ", " + situation.entity(literal.object).id;
  if (!literal.symbol.empty()) text += ", " + literal.symbol;
  return (literal.positive ? "" : "not ") + text + ")";
}

Truths truths_of(std::vector<Literal> literals) {
  sort_unique(literals);
  Truths standing;
  for (Literal& literal : literals) (literal.positive ? standing.yes : standing.no).push_back(std::move(literal));
  return standing;
}

Truths together(const Truths& a, const Truths& b) {
  Truths all;
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

double Experience::surcharge(const Literal& literal) const {
  double sum = 0;
  for (const auto& [known, charge] : literals) {
    if (known == literal) sum += charge;
  }
  return sum;
}

double Experience::surcharge(EntityIndex thing) const {
  double sum = 0;
  for (const auto& [known, charge] : things) {
    if (known == thing) sum += charge;
  }
  return sum;
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

bool clash(const Literal& change, const Truths& standing, const Situation& situation) {
  Literal opposite = change;
  opposite.positive = !change.positive;
  const auto& contrary = opposite.positive ? standing.yes : standing.no;
  if (std::binary_search(contrary.begin(), contrary.end(), opposite)) return true;
  return change.positive && std::any_of(standing.yes.begin(), standing.yes.end(),
                                        [&](const Literal& truth) { return clash(change, truth, situation); });
}

double estimate(const Alternative& alternative, const Situation& situation, const Experience& experience) {
  double cost = 0;
  for (const auto& [known, charge] : experience.literals) {
    if (wants(alternative, known)) cost += charge;
  }
  std::vector<const Literal*> open;
  const auto add = [&](const std::vector<Literal>& literals) {
    for (const Literal& literal : literals) {
      const bool again = std::any_of(open.begin(), open.end(), [&](const Literal* one) { return *one == literal; });
      if (!holds_in(literal, situation.facts()) && !again) open.push_back(&literal);
    }
  };
  add(alternative.end);
  for (const Moment& moment : alternative.moments) add(moment.literals);
  std::vector<EntityIndex> visited, fetched, doors, cut;
  for (const Literal* one : open) {
    const Literal& literal = *one;
    insert_once(visited, literal.subject);
    insert_once(visited, literal.object);
    insert_once(doors, situation.shut_in(literal.subject));
    if (situation.is_imagined(literal.subject)) insert_once(cut, situation.slice(literal.subject).whole);
    const bool placement = is_placement(literal.predicate);
    if (placement || literal.predicate == Predicate::Held || changes_in_hand(literal.predicate)) {
      insert_once(fetched, literal.subject);
    }
    if (!placement) {
      cost += 1;
      if (changes_in_hand(literal.predicate)) cost += 1;
    } else if (literal.positive) {
      cost += 2 + kActionsPerMetre * metres_between(situation, literal.subject, literal.object);
      insert_once(doors, situation.shut_in(literal.object));
      const bool shut =
          literal.predicate == Predicate::Inside && situation.facts().holds(Predicate::Closed, literal.object);
      if (shut) insert_once(doors, literal.object);
    }
  }
  for (const EntityIndex thing : visited) cost += experience.surcharge(thing);
  for (const EntityIndex thing : fetched) cost += 2 + kActionsPerMetre * situation.walk_m(thing);
  for (const EntityIndex thing : visited) {
    const bool also_fetched = std::find(fetched.begin(), fetched.end(), thing) != fetched.end();
    if (!also_fetched) cost += 0.5 * kActionsPerMetre * situation.walk_m(thing);
  }
  for (const EntityIndex door : doors) cost += 2 + kActionsPerMetre * situation.walk_m(door);
  for (const EntityIndex whole : cut) cost += 5 + kActionsPerMetre * situation.walk_m(whole);
  return cost;
}

}  // namespace unietp
