#include "expert/least_steps.h"

#include <algorithm>
#include <map>
#include <vector>

#include "expert/achievers.h"

namespace unietp {
namespace {

constexpr std::size_t kFetchAndDo = 2;  // into the hand, and then what is done with it

/// In or on something of the category, up to five deep: in a home from a file two things may rest on each other.
bool lies_at(const World& world, const std::string& id, std::string_view category, int deep = 5) {
  if (deep == 0) return false;
  for (const Predicate relation : {Predicate::Inside, Predicate::On}) {
    for (const std::string& around : world.linked_from(id, relation)) {
      const Node* node = world.find(around);
      if (node != nullptr && (node->category == category || lies_at(world, around, category, deep - 1))) return true;
    }
  }
  return false;
}

/// Steps that a change of state takes of its own, by the way that takes the fewest.
std::size_t steps_to_change(const Attempt& attempt, const Literal& literal, const Node& node) {
  const Situation& situation = attempt.situation();
  const World& world = attempt.world();
  std::size_t least = kFetchAndDo;
  for (const Achiever& achiever : achievers_of(literal.predicate, situation.profile)) {
    for (const Effect* rule :
         rules_for(achiever, node.category, literal.symbol, world.places(), *situation.knowledge)) {
      if (achiever.kind == AchieverKind::HeldToolOn) least = std::min<std::size_t>(least, 1);
      // Switched on, it does so to all that is there.
      if (achiever.kind == AchieverKind::Appliance && lies_at(world, node.id, rule->tool)) return 0;
    }
  }
  return least;
}

std::size_t own_steps(const Attempt& attempt, const Literal& literal, const Node& node) {
  const std::size_t held = attempt.is_held(node.id) ? 1 : 0;
  // What lies on or in a thing that is put down lies on nothing new: each is put down for itself.
  if (literal.predicate == Predicate::On) return kFetchAndDo - held;
  if (!changes_in_hand(literal.predicate)) return 0;
  const std::size_t steps = steps_to_change(attempt, literal, node);
  return steps > held ? steps - held : 0;
}

/// How many of the things are out of reach from any place where one of the others, of these many, is in reach.
std::size_t apart(const std::vector<const Node*>& things, double reach_m) {
  std::vector<const Node*> taken;
  for (const Node* thing : things) {
    const bool near = std::any_of(taken.begin(), taken.end(), [&](const Node* other) {
      const double between = (thing->pose.position - other->pose.position).head<2>().norm();
      return between <= 2 * reach_m + (thing->size.norm() + other->size.norm()) / 2;
    });
    if (!near) taken.push_back(thing);
  }
  return taken.size();
}

}  // namespace

std::size_t least_steps(const Attempt& attempt) {
  std::map<EntityIndex, std::size_t> by_thing;
  for (const Literal& literal : attempt.alternative().end) {
    if (!literal.positive || attempt.situation().is_imagined(literal.subject) || attempt.holds(literal)) continue;
    const Node* node = attempt.node(literal.subject);
    if (node == nullptr || !node->movable) continue;
    std::size_t& most = by_thing[literal.subject];
    most = std::max(most, own_steps(attempt, literal, *node));
  }
  std::size_t steps = 0;
  std::vector<const Node*> things;
  for (const auto& [thing, own] : by_thing) {
    steps += own;
    if (own > 0) things.push_back(attempt.node(thing));
  }
  const std::size_t walks = apart(things, attempt.world().profile().reach_m);
  return steps + (walks > 0 ? walks - 1 : 0);  // one may be in reach already
}

}  // namespace unietp
