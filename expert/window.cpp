#include "expert/window.h"

#include "akb/default_states.h"

namespace unietp {

EpisodeWindow::EpisodeWindow(ExecutionTree& executions) : rollout_(executions, rules_of(Mode::M2)) {
  const Scene& start = executions.start();
  known_scene_.id = start.id;
  known_scene_.simulator = start.simulator;
  known_scene_.rooms = start.rooms;
  known_scene_.openings = start.openings;
  known_scene_.wall_height = start.wall_height;
  known_scene_.wall_thickness = start.wall_thickness;
  known_scene_.agent = start.agent;
  for (const Node& node : start.nodes) {
    if (node.movable) continue;
    Node& known = known_scene_.nodes.emplace_back(node);
    known.opening = 0;
    known.states = {};
    set_default_states(known, executions.knowledge());
  }
}

std::vector<Node> EpisodeWindow::view() const {
  const World& world = rollout_.episode().world();
  std::vector<Node> seen;
  for (const VisibleObject& object : rollout_.episode().visible()) seen.push_back(*world.find(object.id));
  std::vector<std::string> in_hand = world.agent().held;
  for (std::size_t i = 0; i < in_hand.size(); ++i) {
    seen.push_back(*world.find(in_hand[i]));
    for (std::string& rider : world.resting_at(in_hand[i])) in_hand.push_back(std::move(rider));
  }
  return seen;
}

}  // namespace unietp
