#include "environment/picture_text.h"

#include <map>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/text.h"
#include "environment/agent_text.h"

namespace unietp {
namespace {

/// "dirty", "filled with water"
std::string state_text(const State& state) {
  const std::string name = replace_all(std::string(info(state.predicate).name), "_", " ");
  return state.symbol.empty() ? name : name + " with " + state.symbol;
}

/// The states that one sees, but for those that all objects have at first.
std::vector<std::string> visible_states(const Node& node, Simulator simulator) {
  std::vector<std::string> texts;
  for (const State& state : node.states.all()) {
    const PredicateInfo& about = info(state.predicate);
    const bool is_door = state.predicate == Predicate::Closed || state.predicate == Predicate::Open;
    if (about.telling && shows(simulator, state.predicate) && (is_door || !about.by_default))
      texts.push_back(state_text(state));
  }
  return texts;
}

}  // namespace

std::string picture_text(const Environment& environment) {
  const Observation& seen = environment.observe();
  const Settings& settings = environment.settings();
  const Scene& scene = environment.scene();
  const bool by_id = seen.boxes.has_value();
  std::map<std::string, PixelBox> boxes;
  if (by_id) {
    for (const ObservedObject& object : *seen.boxes) boxes.emplace(object.id, object.box);
  } else {
    for (const VisibleObject& object : environment.pictured()) boxes.emplace(object.id, object.box);
  }
  std::map<std::string, const Node*> nodes;
  for (const Node& node : scene.nodes) {
    if (boxes.contains(node.id)) nodes.emplace(node.id, &node);
  }
  const auto name = [&](const Node& node) { return by_id ? node.id : node.category; };
  std::map<std::string, std::vector<std::string>> facts;
  for (const auto& [id, node] : nodes) facts[id] = visible_states(*node, scene.simulator);
  for (const Edge& edge : scene.edges) {
    if (edge.relation != Predicate::On && edge.relation != Predicate::Inside) continue;
    const auto below = nodes.find(edge.to);
    if (nodes.contains(edge.from) && below != nodes.end())
      facts[edge.from].push_back((edge.relation == Predicate::On ? "on " : "in ") + name(*below->second));
  }
  std::vector<std::string> things;
  for (const auto& [id, node] : nodes) {
    const auto& states = facts[id];
    if (by_id && states.empty()) continue;
    std::string text = name(*node);
    if (!by_id) {
      const nlohmann::json numbers = box_in_form(boxes[id], settings.box_form, seen.image_width, seen.image_height);
      text +=
          " " + (settings.box_form == BoxForm::Unit ? numbers
                                                    : nlohmann::json(std::vector<int>(numbers.begin(), numbers.end())))
                    .dump();
    }
    things.push_back(states.empty() ? text : text + (by_id ? " is " : ", ") + join(states, ", "));
  }
  if (things.empty()) return by_id ? "" : "The camera shows nothing.";
  return "The camera shows: " + join(things, "; ") + ".";
}

}  // namespace unietp
