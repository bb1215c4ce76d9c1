#include "interchange/behavior_objects.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "core/limits.h"
#include "interchange/foreign_json.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;
using Registry = std::map<std::string_view, const Json*>;

/// A list of names, or one name; an empty one is none.
std::vector<std::string> names_at(JsonReader& reader, const JsonAt& at) {
  if (!at.json.is_string()) return reader.texts(at);
  std::string name = at.json.get<std::string>();
  return name.empty() ? std::vector<std::string>() : std::vector{std::move(name)};
}

void read_what(JsonReader& reader, const JsonAt& at, BehaviorObject& object) {
  if (const auto f = given(at, "category")) object.category = reader.text(*f);
  if (const auto f = given(at, "model")) object.model = reader.text(*f);
  if (const auto f = given(at, "scale")) {
    object.scale = f->json.is_number() ? Vec3(Vec3::Ones() * reader.number(*f)) : reader.vec3(*f);
    object.scale = object.scale.cwiseAbs();
  }
  if (const auto f = given(at, "bounding_box")) {
    object.box = reader.vec3(*f);
    if (!reader.error() && !(object.box.minCoeff() > 0)) reader.fail(*f, "expected three lengths > 0");
  }
  if (const auto f = given(at, "fixed_base")) object.fixed = reader.boolean(*f);
  if (const auto f = given(at, "in_rooms")) object.rooms = names_at(reader, *f);
}

/// A number or a list of them.
double largest(JsonReader& reader, const JsonAt& at) {
  if (at.json.is_number()) return std::abs(reader.number(at));
  double most = 0;
  const std::size_t count = reader.items(at);
  for (std::size_t i = 0; i < count && !reader.error(); ++i) {
    most = std::max(most, std::abs(reader.number(reader.item(at, i))));
  }
  return most;
}

double largest_joint(JsonReader& reader, const JsonAt& joints) {
  const auto* fields = joints.json.get_ptr<const Json::object_t*>();
  if (fields == nullptr) return largest(reader, joints);
  double most = 0;
  for (const auto& [name, value] : *fields) {
    const JsonAt joint{value, &joints, name, 0};
    if (const auto position = given(joint, "pos")) {
      most = std::max(most, largest(reader, *position));
    } else if (!joint.json.is_object()) {
      most = std::max(most, largest(reader, joint));
    }
    if (reader.error()) break;
  }
  return most;
}

void read_pose(JsonReader& reader, const JsonAt& at, std::string_view rotation, BehaviorObject& object) {
  JsonFields fields(reader, at);
  if (const auto f = fields.required("pos")) object.root.position = reader.vec3(*f);
  if (const auto f = fields.required(rotation)) {
    object.root.rotation = rounded_rotation(reader, *f, QuatOrder::Xyzw);
  }
}

std::vector<BehaviorObject> read_flat(JsonReader& reader, const JsonAt& list) {
  std::vector<BehaviorObject> objects;
  const std::size_t count = objects_in(reader, list);
  for (std::size_t i = 0; i < count && !reader.error(); ++i) {
    const JsonAt at = reader.item(list, i);
    BehaviorObject object;
    JsonFields fields(reader, at);
    if (const auto f = fields.required("name")) object.name = reader.text(*f);
    if (reader.error()) break;
    read_what(reader, at, object);
    read_pose(reader, at, "ori_xyzw", object);
    if (const auto f = given(at, "joints")) object.joint = largest_joint(reader, *f);
    objects.push_back(std::move(object));
  }
  return objects;
}

void read_state(JsonReader& reader, const JsonAt& at, BehaviorObject& object) {
  JsonFields fields(reader, at);
  if (const auto f = fields.required("root_link")) read_pose(reader, *f, "ori", object);
  if (const auto f = given(at, "joints")) object.joint = largest_joint(reader, *f);
  if (const auto f = given(at, "joint_pos")) object.joint = largest_joint(reader, *f);
  const auto states = given(at, "non_kin");
  const auto toggled = states ? given(*states, "ToggledOn") : std::nullopt;
  const auto value = toggled ? given(*toggled, "value") : std::nullopt;
  if (!value) return;
  object.has_switch_state = true;
  object.switched_on = reader.boolean(*value);
}

}  // namespace

std::vector<BehaviorObject> read_behavior_objects(JsonReader& reader, const JsonAt& home,
                                                  std::vector<std::string>& missing) {
  if (const auto list = given(home, "objects")) return read_flat(reader, *list);
  std::vector<BehaviorObject> objects;
  JsonFields fields(reader, home);
  const auto what = fields.required("objects_info");
  const auto state = fields.required("state");
  if (!what || !state) return objects;
  JsonFields what_fields(reader, *what);
  const auto init = what_fields.required("init_info");
  if (!init) return objects;
  const auto inner = given(*state, "registry");
  const JsonAt& registry_holder = inner ? *inner : *state;
  JsonFields state_fields(reader, registry_holder);
  const auto registry = state_fields.required("object_registry");
  if (!registry) return objects;
  const auto* infos = init->json.get_ptr<const Json::object_t*>();
  const auto* places = registry->json.get_ptr<const Json::object_t*>();
  if (infos == nullptr) reader.fail(*init, "expected an object of objects by name");
  if (places == nullptr) reader.fail(*registry, "expected an object of objects by name");
  if (reader.error()) return objects;
  if (infos->size() > limits::kListedObjects) {
    reader.fail(*init, std::to_string(infos->size()) + " objects in one home; expected at most " +
                           std::to_string(limits::kListedObjects));
    return objects;
  }
  Registry by_name;
  for (const auto& [name, place] : *places) by_name.emplace(name, &place);
  for (const auto& [name, info] : *infos) {
    const JsonAt at{info, &*init, name, 0};
    JsonFields info_fields(reader, at);
    BehaviorObject object;
    object.name = name;
    if (const auto module = given(at, "class_module")) {
      object.robot = reader.text(*module).find(".robots") != std::string::npos;
    }
    if (const auto args = info_fields.required("args")) read_what(reader, *args, object);
    const auto place = by_name.find(name);
    if (place == by_name.end()) {
      missing.push_back(name);
      continue;
    }
    read_state(reader, JsonAt{*place->second, &*registry, name, 0}, object);
    if (reader.error()) break;
    objects.push_back(std::move(object));
  }
  return objects;
}

}  // namespace unietp
