#include "environment/observation_json.h"

#include <nlohmann/json.hpp>

#include "environment/agent_text.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const NamedThing& thing) { return {{"id", thing.id}, {"category", thing.category}}; }
Json to_json(const HeldThing& thing) {
  Json json = Json::object();
  if (!thing.id.empty()) json["id"] = thing.id;
  json["category"] = thing.category;
  return json;
}

Json to_json(const ActionReport& report) {
  Json json{{"action", report.action}};
  if (!report.success) return json;
  json["success"] = *report.success;
  if (report.failure == Failure::None) return json;
  json["failure"] = name_of(report.failure);
  json["feedback"] = report.feedback;
  return json;
}

Json to_json(const RoomContents& contents);

template <class Thing>
Json list_of(const std::vector<Thing>& things) {
  Json list = Json::array();
  for (const Thing& thing : things) list.push_back(to_json(thing));
  return list;
}

Json to_json(const RoomContents& contents) {
  Json json = Json::object();
  if (!contents.room.id.empty()) json["room"] = to_json(contents.room);
  if (!contents.furniture.empty()) json["furniture"] = list_of(contents.furniture);
  if (!contents.movables.empty()) json["movables"] = list_of(contents.movables);
  return json;
}

Json boxes_to_json(const Observation& observation, BoxForm form) {
  Json list = Json::array();
  for (const SeenObject& object : *observation.boxes) {
    Json box = object.box;
    if (form == BoxForm::Unit) {
      box = box_in_form(object.box, form, observation.image_width, observation.image_height);
    } else if (form != BoxForm::Pixels) {
      box = Json::array();
      for (const double number : box_in_form(object.box, form, observation.image_width, observation.image_height))
        box.push_back(static_cast<int>(number));
    }
    list.push_back({{"id", object.id}, {"category", object.category}, {"box", std::move(box)}});
  }
  return list;
}

}  // namespace

Json observation_to_json(const Observation& observation, const Settings& settings) {
  const ModeRules& rules = settings.rules;
  const HomeInformation& home = *observation.home;
  Json json{{"instruction", observation.instruction}};
  if (observation.has_picture)
    json["image"] = {{"width", observation.image_width}, {"height", observation.image_height}};
  if (observation.boxes) json["boxes"] = boxes_to_json(observation, settings.box_form);
  if (settings.global == GlobalForm::ByRoom) {
    json["by_room"] = list_of(home.by_room);
  } else {
    if (rules.rooms) json["rooms"] = list_of(home.rooms);
    if (rules.furniture) json["furniture"] = list_of(home.furniture);
    if (rules.movables) json["movables"] = list_of(home.movables);
  }
  json["last"] = observation.last ? to_json(*observation.last) : Json();
  json["results"] = list_of(observation.results);
  if (observation.held) json["held"] = list_of(*observation.held);
  json["step"] = observation.step;
  json["steps_left"] = observation.steps_left;
  if (observation.failures_left) json["failures_left"] = *observation.failures_left;
  json["over"] = observation.over;
  return json;
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
