#include "expert/estimate.h"

#include <algorithm>

#include "expert/achievers.h"

namespace unietp {
namespace {

constexpr double kActionsPerMeter = 0.1;

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

void insert_once(std::vector<EntityIndex>& list, EntityIndex entity) {
  if (entity != kNobody && std::find(list.begin(), list.end(), entity) == list.end()) list.push_back(entity);
}

double meters_between(const Situation& situation, EntityIndex a, EntityIndex b) {
  const Node* from = situation.node(a);
  const Node* to = b == kNobody ? nullptr : situation.node(b);
  if (from == nullptr || to == nullptr) return 0;
  return (from->pose.position - to->pose.position).head<2>().norm();
}

}  // namespace

double CostPenalties::penalty(const Literal& literal) const {
  double sum = 0;
  for (const auto& [known, charge] : literals) {
    if (known == literal) sum += charge;
  }
  return sum;
}

double CostPenalties::penalty(EntityIndex thing) const {
  double sum = 0;
  for (const auto& [known, charge] : things) {
    if (known == thing) sum += charge;
  }
  return sum;
}

double estimate(const Alternative& alternative, const Situation& situation, const CostPenalties& experience) {
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
      cost += 2 + kActionsPerMeter * meters_between(situation, literal.subject, literal.object);
      insert_once(doors, situation.shut_in(literal.object));
      const bool shut =
          literal.predicate == Predicate::Inside && situation.facts().holds(Predicate::Closed, literal.object);
      if (shut) insert_once(doors, literal.object);
    }
  }
  for (const EntityIndex thing : visited) cost += experience.penalty(thing);
  for (const EntityIndex thing : fetched) cost += 2 + kActionsPerMeter * situation.walk_m(thing);
  for (const EntityIndex thing : visited) {
    const bool also_fetched = std::find(fetched.begin(), fetched.end(), thing) != fetched.end();
    if (!also_fetched) cost += 0.5 * kActionsPerMeter * situation.walk_m(thing);
  }
  for (const EntityIndex door : doors) cost += 2 + kActionsPerMeter * situation.walk_m(door);
  for (const EntityIndex whole : cut) cost += 5 + kActionsPerMeter * situation.walk_m(whole);
  return cost;
}

}  // namespace unietp
