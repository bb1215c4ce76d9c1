#include "damaged_task.h"

#include <algorithm>

namespace unietp {

using Json = nlohmann::ordered_json;

Json* DamagedTask::last_step(std::initializer_list<const char*> actions) {
  auto& steps = demonstration["steps"];
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
    if (std::any_of(actions.begin(), actions.end(), [&](const char* name) { return (*step)["action"] == name; }))
      return &*step;
  }
  return nullptr;
}

Json DamagedTask::line() const {
  const auto among = [](const Json& list, const auto& is_it) { return std::any_of(list.begin(), list.end(), is_it); };
  Json changes = Json::object();
  for (const auto& node : scene["nodes"]) {
    if (!among(home["nodes"], [&](const Json& one) { return one == node; })) changes["nodes"].push_back(node);
  }
  // A start lists new things after those of the home, its changes all by id.
  if (changes.contains("nodes"))
    std::sort(changes["nodes"].begin(), changes["nodes"].end(),
              [](const Json& a, const Json& b) { return a["id"] < b["id"]; });
  for (const auto& node : home["nodes"]) {
    if (!among(scene["nodes"], [&](const Json& one) { return one["id"] == node["id"]; }))
      changes["removed"].push_back(node["id"]);
  }
  for (const auto& edge : scene["edges"]) {
    if (!among(home["edges"], [&](const Json& one) { return one == edge; })) changes["edges_added"].push_back(edge);
  }
  for (const auto& edge : home["edges"]) {
    if (!among(scene["edges"], [&](const Json& one) { return one == edge; })) changes["edges_removed"].push_back(edge);
  }
  if (scene["agent"] != home["agent"]) changes["agent"] = scene["agent"];
  Json changed = task;
  changed["start"]["changes"] = changes;
  return changed;
}

std::string DamagedTask::category_of(const std::string& id) const {
  for (const auto& node : scene["nodes"]) {
    if (node["id"] == id) return node["category"];
  }
  return "";
}

}  // namespace unietp
