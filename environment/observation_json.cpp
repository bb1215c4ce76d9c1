#include "environment/observation_json.h"

#include <nlohmann/json.hpp>

#include "environment/observation_tree.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

struct JsonMaker {
  using Value = Json;
  static Json text(const std::string& words) { return words; }
  static Json number(int number) { return number; }
  static Json real(double number) { return number; }
  static Json flag(bool flag) { return flag; }
  static Json nothing() { return {}; }
  static Json object() { return Json::object(); }
  static Json list() { return Json::array(); }
  // Every name is set once, so there is no search for it as in object[name].
  static void set(Json& object, const char* name, Json value) {
    object.get_ref<Json::object_t&>().emplace_back(name, std::move(value));
  }
  static void append(Json& list, Json value) { list.push_back(std::move(value)); }
};

}  // namespace

Json observation_to_json(const Observation& observation, const Settings& settings) {
  return ObservationTree<JsonMaker>(observation, settings).value();
}

Json step_to_json(const StepResult& step, const Settings& settings) {
  return {{"observation", observation_to_json(step.observation, settings)},
          {"reward", step.reward},
          {"terminated", step.terminated},
          {"truncated", step.truncated}};
}

Json privileged_to_json(const PrivilegedState& state) {
  return {{"success", state.success},   {"hopeless", state.hopeless}, {"progress", state.progress},
          {"missing", state.missing},   {"goal", state.goal},         {"steps", state.steps},
          {"failures", state.failures}, {"ended_by", state.ended_by}};
}

}  // namespace unietp
