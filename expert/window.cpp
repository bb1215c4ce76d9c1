#include "expert/window.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "akb/default_states.h"
#include "simulation/view.h"

namespace unietp {
namespace {

constexpr std::string_view kInHand = "in hand ";

std::string name_of(const PixelBox& box) {
  std::string name;
  for (const int edge : box) name += (name.empty() ? "" : " ") + std::to_string(edge);
  return name;
}

/// What can be pointed at, by its box.
std::map<PixelBox, std::string> pictured(const World& world) {
  std::map<PixelBox, std::string> shown;  // "": a box of several, which means none of them
  for (const VisibleObject& object : world.pictured()) {
    const auto [box, is_new] = shown.emplace(object.box, object.id);
    if (!is_new) box->second = "";
  }
  std::erase_if(shown, [](const auto& one) { return one.second.empty() || !shows_clearly(one.first); });
  return shown;
}

/// A thing as it looks, and not what only the simulation knows of it.
Node as_seen(Node node, const Knowledge& knowledge) {
  const Category* kind = knowledge.find(node.category);
  if (kind != nullptr) node.mass = kind->mass * node.size.prod() / kind->size.prod();
  node.asset.clear();
  node.slice_of.clear();
  return node;
}

/// Furniture as a plan of the home shows it: what it is, where it stands and how large it is, in its default states.
Node as_on_a_plan(const Node& node, const Knowledge& knowledge) {
  Node known = as_seen(node, knowledge);
  known.color.clear();
  known.material.clear();
  known.boards.clear();
  known.opening = 0;
  known.states = {};
  set_default_states(known, knowledge);
  return known;
}

bool comes_first(const Node& a, const Node& b) {
  const auto by_look = [](const Node& node) {
    const Vec3& at = node.pose.position;
    return std::tuple(std::string_view(node.category), at.x(), at.y(), at.z());
  };
  return by_look(a) < by_look(b);
}

}  // namespace

bool is_in_hand(std::string_view name) { return name.starts_with(kInHand); }

EpisodeWindow::EpisodeWindow(ExecutionTree& executions, Mode mode)
    : rollout_(executions, rules_of(mode)), knowledge_(executions.knowledge()) {
  const Scene& start = executions.start();
  known_scene_.id = start.id;
  known_scene_.simulator = start.simulator;
  known_scene_.rooms = start.rooms;
  known_scene_.openings = start.openings;
  known_scene_.wall_height = start.wall_height;
  known_scene_.wall_thickness = start.wall_thickness;
  if (rollout_.episode().rules().furniture) {
    for (const Node& node : start.nodes) {
      if (!node.movable) known_scene_.nodes.push_back(as_on_a_plan(node, knowledge_));
    }
  }
  look();
  known_scene_.agent = body_;
}

Outcome EpisodeWindow::act(const Action& action) {
  Action meant = action;
  if (points()) {
    for (std::string& name : meant.args) {
      if (const auto id = meant_.find(name); id != meant_.end()) {
        name = id->second;
      } else if (find_room(known_scene_, name) == nullptr) {
        return {false, Failure::NotSeenYet, "nothing is called " + name};
      }
    }
  }
  Outcome outcome = rollout_.go_on(meant);
  if (outcome.success && meant.type != ActionType::Stop) look();
  return outcome;
}

/// What is held, then what lies on or in that, in an order that does not depend on ids.
std::vector<std::string> EpisodeWindow::in_the_hand() const {
  const World& world = rollout_.episode().world();
  std::vector<std::string> in_hand = world.agent().held;
  for (std::size_t i = 0; i < in_hand.size(); ++i) {
    std::vector<std::string> riders = world.resting_at(in_hand[i]);
    std::sort(riders.begin(), riders.end(),
              [&](const std::string& a, const std::string& b) { return comes_first(*world.find(a), *world.find(b)); });
    in_hand.insert(in_hand.end(), riders.begin(), riders.end());
  }
  return in_hand;
}

void EpisodeWindow::show(const std::string& id, std::string name) {
  const Node& node = *rollout_.episode().world().find(id);
  if (!points()) {
    view_.push_back(node);
    return;
  }
  Node seen = as_seen(node, knowledge_);
  seen.id = std::move(name);
  meant_[seen.id] = id;
  view_.push_back(std::move(seen));
}

void EpisodeWindow::look() {
  const World& world = rollout_.episode().world();
  view_.clear();
  meant_.clear();
  if (points()) {
    for (const auto& [box, id] : pictured(world)) show(id, name_of(box));
  } else {
    for (const VisibleObject& object : rollout_.episode().visible()) show(object.id, {});
  }
  body_ = world.agent();
  const auto in_hand = in_the_hand();
  for (std::size_t i = 0; i < in_hand.size(); ++i) {
    std::string name = std::string(kInHand) + std::to_string(i + 1);
    if (points() && i < body_.held.size()) body_.held[i] = name;
    show(in_hand[i], std::move(name));
  }
}

}  // namespace unietp
