#include "environment/picture_text.h"

#include <map>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/text.h"
#include "environment/agent_text.h"
#include "environment/environment.h"

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

/// An object in the picture: its id, and what it is called.
using Names = std::map<std::string, std::string>;

/// For each named object, by id, its states and what it is on or in, by name.
std::map<std::string, std::vector<std::string>> facts_of(const Scene& scene, const Names& names) {
  std::map<std::string, std::vector<std::string>> facts;
  for (const Node& node : scene.nodes) {
    if (names.contains(node.id)) facts[node.id] = visible_states(node, scene.simulator);
  }
  for (const Edge& edge : scene.edges) {
    if (edge.relation != Predicate::On && edge.relation != Predicate::Inside) continue;
    const auto above = facts.find(edge.from);
    const auto below = names.find(edge.to);
    if (above != facts.end() && below != names.end())
      above->second.push_back((edge.relation == Predicate::On ? "on " : "in ") + below->second);
  }
  return facts;
}

std::string sentence(const std::vector<std::string>& things, const std::string& without) {
  return things.empty() ? without : "The camera shows: " + join(things, "; ") + ".";
}

}  // namespace

std::string picture_text(const Scene& scene, const std::vector<VisibleObject>& boxes) {
  Names names;
  for (const VisibleObject& object : boxes) names.emplace(object.id, object.id);
  std::vector<std::string> things;
  for (const auto& [id, facts] : facts_of(scene, names)) {
    if (!facts.empty()) things.push_back(id + " is " + join(facts, ", "));
  }
  return sentence(things, "");
}

std::string picture_text(const Environment& environment) {
  const Observation& seen = environment.observe();
  const Settings& settings = environment.settings();
  if (seen.boxes) {
    std::vector<VisibleObject> boxes;
    for (const ObservedObject& object : *seen.boxes) boxes.push_back({object.id, object.box});
    return picture_text(environment.scene(), boxes);
  }
  std::map<std::string, PixelBox> boxes;
  for (const VisibleObject& object : environment.pictured()) boxes.emplace(object.id, object.box);
  Names names;
  for (const Node& node : environment.scene().nodes) {
    if (boxes.contains(node.id)) names.emplace(node.id, node.category);
  }
  const auto box_text = [&](const std::string& id) {
    const auto numbers = box_in_form(boxes.at(id), settings.box_form, seen.image_width, seen.image_height);
    if (settings.box_form == BoxForm::Unit) return nlohmann::json(numbers).dump();
    return nlohmann::json(std::vector<int>(numbers.begin(), numbers.end())).dump();
  };
  std::vector<std::string> things;
  for (const auto& [id, facts] : facts_of(environment.scene(), names)) {
    const std::string thing = names.at(id) + " " + box_text(id);
    things.push_back(facts.empty() ? thing : thing + ", " + join(facts, ", "));
  }
  return sentence(things, "The camera shows nothing.");
}

}  // namespace unietp
