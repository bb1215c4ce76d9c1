#include "expert/window.h"

#include "akb/default_states.h"

namespace unietp {

EpisodeWindow::EpisodeWindow(ExecutionTree& executions) : rollout_(executions, rules_of(Mode::M2)) {
  const Scene& start = executions.start();
  told_.id = start.id;
  told_.simulator = start.simulator;
  told_.rooms = start.rooms;
  told_.openings = start.openings;
  told_.wall_height = start.wall_height;
  told_.wall_thickness = start.wall_thickness;
  told_.agent = start.agent;
  for (const Node& node : start.nodes) {
    if (node.movable) continue;
    Node& known = told_.nodes.emplace_back(node);
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
