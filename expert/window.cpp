#include "expert/window.h"

#include <string_view>
#include <utility>

#include "akb/default_states.h"
#include "scene/fresh_id.h"
#include "simulation/view.h"

namespace unietp {

EpisodeWindow::EpisodeWindow(ExecutionTree& executions, Mode mode) : rollout_(executions, rules_of(mode)) {
  const Scene& start = executions.start();
  known_scene_.id = start.id;
  known_scene_.simulator = start.simulator;
  known_scene_.rooms = start.rooms;
  known_scene_.openings = start.openings;
  known_scene_.wall_height = start.wall_height;
  known_scene_.wall_thickness = start.wall_thickness;
  named_ = known_scene_;
  if (rollout_.episode().rules().furniture) {
    for (const Node& node : start.nodes) {
      if (node.movable) continue;
      Node& known = known_scene_.nodes.emplace_back(node);
      known.opening = 0;
      known.states = {};
      set_default_states(known, executions.knowledge());
    }
  }
  look();
  known_scene_.agent = body_;
}

Outcome EpisodeWindow::act(const Action& action) {
  Action meant = action;
  if (points()) {
    for (std::string& name : meant.args) {
      if (const auto id = ids_.find(name); id != ids_.end()) {
        name = id->second;
      } else if (find_room(known_scene_, name) == nullptr) {
        return {false, Failure::NotSeenYet, "nothing was called " + name};
      }
    }
  }
  Outcome outcome = rollout_.go_on(meant);
  if (!outcome.success || meant.type == ActionType::Stop) return outcome;
  if (meant.type == ActionType::Slice) {  // who cuts a thing knows its slices
    for (const Node& node : rollout_.episode().world().changes().nodes) {
      if (!node.slice_of.empty()) give_name(node);
    }
  }
  look();
  return outcome;
}

std::vector<std::string> EpisodeWindow::in_the_hand() const {
  const World& world = rollout_.episode().world();
  std::vector<std::string> in_hand = world.agent().held;
  for (std::size_t i = 0; i < in_hand.size(); ++i) {
    for (std::string& rider : world.resting_at(in_hand[i])) in_hand.push_back(std::move(rider));
  }
  return in_hand;
}

std::vector<std::string> EpisodeWindow::pictured() const {
  std::map<PixelBox, std::string_view> shown;  // "": a box of several, which means none of them
  for (const VisibleObject& object : rollout_.episode().world().pictured()) {
    const auto [box, is_new] = shown.emplace(object.box, object.id);
    if (!is_new) box->second = "";
  }
  std::vector<std::string> ids;
  for (const auto& [box, id] : shown) {
    if (!id.empty() && shows_clearly(box)) ids.emplace_back(id);
  }
  return ids;
}

void EpisodeWindow::give_name(const Node& node) {
  if (!points() || names_.contains(node.id)) return;
  Node named;
  named.id = fresh_id(named_, named_places_, node.category);
  named.category = node.category;
  names_[node.id] = named.id;
  ids_[named.id] = node.id;
  named_places_.add(named_.nodes.size(), named);
  named_.nodes.push_back(std::move(named));
}

Node EpisodeWindow::renamed(Node node) const {
  if (!points()) return node;
  node.id = names_.find(node.id)->second;
  const auto whole = names_.find(node.slice_of);
  node.slice_of = whole == names_.end() ? "" : whole->second;
  return node;
}

void EpisodeWindow::look() {
  const World& world = rollout_.episode().world();
  std::vector<std::string> ids;
  if (points()) {
    ids = pictured();
  } else {
    for (const VisibleObject& object : rollout_.episode().visible()) ids.push_back(object.id);
  }
  const auto in_hand = in_the_hand();
  ids.insert(ids.end(), in_hand.begin(), in_hand.end());
  view_.clear();
  for (const std::string& id : ids) {
    const Node node = *world.find(id);
    give_name(node);
    view_.push_back(renamed(node));
  }
  body_ = world.agent();
  if (points()) {
    for (std::string& id : body_.held) id = names_.find(id)->second;
  }
}

}  // namespace unietp
