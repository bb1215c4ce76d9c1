#include "small_home.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "akb/default_states.h"
#include "core/rng.h"
#include "interchange/category_names.h"
#include "scene/fresh_id.h"
#include "tests/interchange/import_rates.h"

namespace unietp::testing {
namespace {

double area_of(const std::vector<Vec2>& polygon) {
  double twice = 0;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    twice += polygon[j].x() * polygon[i].y() - polygon[i].x() * polygon[j].y();
  }
  return twice / 2;
}

void set_drawn_states(Node& node, const Knowledge& knowledge, Rng& rng) {
  set_default_states(node, knowledge);
  if (knowledge.has(node.category, "switchable") && rng.chance(0.5)) node.states.set({Predicate::PowerOn, ""});
  if (knowledge.has(node.category, "dirtyable") && rng.chance(0.5)) node.states.set({Predicate::Dirty, ""});
  if (node.openable && node.archetype == Archetype::Cabinet && rng.chance(0.5)) {
    node.states.set({Predicate::Open, ""});
    node.opening = 1;
  }
}

}  // namespace

Scene small_home(const Knowledge& knowledge, std::uint64_t seed) {
  Rng rng(seed);
  Scene home;
  home.id = "small_home";
  home.simulator = knowledge.simulator();
  home.wall_height = 2.5;
  home.rooms = {{"kitchen_1", "kitchen", {{0, 0}, {20, 0}, {20, 10}, {16, 10}, {16, 14}, {0, 14}}},
                {"bedroom_1", "bedroom", {{20, 0}, {30, 0}, {30, 10}, {20, 10}}}};
  home.openings = {{"opening_1", "kitchen_1", "bedroom_1", {20, 1}, {20, 1.9}, 2}};
  home.agent.position = {2, 12};
  home.agent.yaw = rng.uniform(-3, 3);
  const auto& categories = knowledge.categories();
  for (int i = 0; i < 24; ++i) {
    const Category& category = categories[rng.below(categories.size())];
    const bool measured_open = category.archetype == Archetype::Folding || category.archetype == Archetype::Lidded;
    if (measured_open || is_of_the_building(category.name, format_facts()) || category.size.maxCoeff() > 1.5) continue;
    Node node;
    node.id = fresh_id(home, category.name);
    node.category = category.name;
    node.movable = category.movable;
    node.archetype = category.archetype;
    node.openable = knowledge.has(category.name, "openable");
    node.size = category.size * rng.uniform(0.8, 1.2);
    node.mass = category.mass;
    const Vec3 place(1.5 + 2.3 * (i % 8), 1.5 + 2.5 * (i / 8), node.size.z() / 2 + rng.uniform(0.1, 1));
    node.pose = upright(place, rng.uniform(-3.1, 3.1));
    set_drawn_states(node, knowledge, rng);
    home.nodes.push_back(std::move(node));
  }
  return home;
}

std::vector<std::string> differences(const Scene& home, const Scene& again, double tolerance_m) {
  std::vector<std::string> found;
  const auto far = [&](double a, double b) { return !(std::abs(a - b) <= tolerance_m); };
  if (home.rooms.size() != again.rooms.size()) found.push_back("another number of rooms");
  for (std::size_t i = 0; i < std::min(home.rooms.size(), again.rooms.size()); ++i) {
    const Room &a = home.rooms[i], &b = again.rooms[i];
    if (a.type != b.type || a.polygon.size() != b.polygon.size() || far(area_of(a.polygon), area_of(b.polygon))) {
      found.push_back(a.id + " is another room");
    }
  }
  if (home.openings.size() != again.openings.size()) found.push_back("another number of openings");
  for (std::size_t i = 0; i < std::min(home.openings.size(), again.openings.size()); ++i) {
    const Opening &a = home.openings[i], &b = again.openings[i];
    const double ends =
        std::min((a.from - b.from).norm() + (a.to - b.to).norm(), (a.from - b.to).norm() + (a.to - b.from).norm());
    if (far(ends, 0) || far(a.height, b.height)) found.push_back(a.id + " is another opening");
  }
  if (far((home.agent.position - again.agent.position).norm(), 0)) found.push_back("the agent stands elsewhere");
  if (far(std::remainder(home.agent.yaw - again.agent.yaw, 2 * std::numbers::pi), 0))
    found.push_back("the agent turned");
  if (home.nodes.size() != again.nodes.size()) found.push_back("another number of objects");
  std::vector<const Node*> rest;
  for (const Node& node : again.nodes) rest.push_back(&node);
  for (const Node& node : home.nodes) {
    const auto same = std::find_if(rest.begin(), rest.end(), [&](const Node* other) {
      return other->category == node.category && !far((other->pose.position - node.pose.position).norm(), 0);
    });
    if (same == rest.end()) {
      found.push_back(node.id + " is nowhere");
      continue;
    }
    const Node& other = **same;
    rest.erase(same);
    if (far((other.size - node.size).norm(), 0)) found.push_back(node.id + " has another size");
    if (far(other.pose.rotation.angularDistance(node.pose.rotation), 0)) found.push_back(node.id + " turned");
    if (!(other.states == node.states)) found.push_back(node.id + " has other states");
    if (far(other.opening, node.opening)) found.push_back(node.id + " is open in another way");
  }
  return found;
}

}  // namespace unietp::testing
