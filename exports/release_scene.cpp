#include "exports/release_scene.h"

#include <algorithm>
#include <string_view>

#include <nlohmann/json.hpp>

#include "interchange/formats.h"
#include "interchange/habitat_frame.h"
#include "interchange/unity.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

Json numbers(const Vec3& v) { return Json::array({v.x(), v.y(), v.z()}); }
Vec3 place_of(const Agent& agent) { return {agent.position.x(), agent.position.y(), 0}; }

/// Their scene graph knows four states and stops at others, and at those of which the node has not the property.
void keep_known_states(Json& graph) {
  for (Json& node : graph["nodes"]) {
    const Json properties = node["properties"];
    const auto has = [&](const char* property) {
      return std::find(properties.begin(), properties.end(), property) != properties.end();
    };
    Json kept = Json::array();
    for (const auto& state : node["states"]) {
      const bool of_door = state == "OPEN" || state == "CLOSED", of_switch = state == "ON" || state == "OFF";
      if ((of_door && has("CAN_OPEN")) || (of_switch && has("HAS_SWITCH"))) kept.push_back(state);
    }
    node["states"] = std::move(kept);
  }
}

ReleaseScene virtualhome(const Scene& start, ExportedScene written) {
  Json graph = Json::parse(written.text);
  keep_known_states(graph);
  ReleaseScene scene;
  scene.record =
      Json{{"scene_id", 0}, {"vheg", std::move(graph)}, {"initial_position", numbers(to_unity(place_of(start.agent)))}}
          .dump();
  scene.not_said = std::move(written.left_out);
  scene.not_said.emplace_back(
      "walls and rooms: the runner loads apartment 0 of VirtualHome and expands the graph in it");
  scene.names = std::move(written.names);
  return scene;
}

ReleaseScene habitat(const std::string& name, const Scene& start, ExportedScene written) {
  ReleaseScene scene;
  const Json none = Json::array();
  scene.record = Json{
      {"scene_id", name},
      {"initial_position", numbers(to_habitat(place_of(start.agent)))},
      {"all_placement", none},
      {"all_state_change", none},
      {"all_new_placement",
       none}}.dump();
  scene.file = "scenes-articulated/" + name + ".scene_instance.json";
  scene.file_text = std::move(written.text);
  scene.not_said = std::move(written.left_out);
  return scene;
}

ReleaseScene ai2thor(const std::string& name, ExportedScene written) {
  ReleaseScene scene;
  scene.file = "houses/" + name + ".json";
  scene.file_text = std::move(written.text);
  scene.not_said = std::move(written.left_out);
  scene.not_said.insert(scene.not_said.begin(),
                        "the home: a record names a ProcTHOR-10k house by number or an iTHOR scene by name; "
                        "AI2-THOR can build it from " +
                            scene.file + " (CreateHouse)");
  scene.names = std::move(written.names);
  return scene;
}

}  // namespace

Result<ReleaseScene> release_scene(const std::string& name, const Scene& start, const Knowledge& knowledge,
                                   const FormatFacts& facts) {
  if (start.simulator == Simulator::Behavior) {
    ReleaseScene scene;
    scene.not_said.emplace_back("the home: records name an OmniGibson scene file, which is not written");
    for (const Node& node : start.nodes) scene.names[node.id] = node.id;
    return scene;
  }
  auto written = start.simulator == Simulator::Ai2thor   ? write_procthor(start, knowledge, facts)
                 : start.simulator == Simulator::Habitat ? write_habitat(start, knowledge)
                                                         : write_virtualhome(start, knowledge, facts);
  if (!written) return written.error();
  if (start.simulator == Simulator::Ai2thor) return ai2thor(name, std::move(*written));
  if (start.simulator == Simulator::Habitat) return habitat(name, start, std::move(*written));
  return virtualhome(start, std::move(*written));
}

}  // namespace unietp
