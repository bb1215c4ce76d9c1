#include "simulation/profile.h"

#include <set>

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/limits.h"
#include "scene/json_parse.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

/// Reads fields one by one, remembers the first error and which fields it knows.
class Fields {
 public:
  Fields(const Json& json, std::string where, std::string pointer = "")
      : json_(json), where_(std::move(where)), pointer_(std::move(pointer)) {}

  void positive(const char* name, double& value) {
    if (const Json* field = find(name, &Json::is_number, "a number")) {
      value = field->get<double>();
      if (!(value > 0)) fail(name, "must be greater than 0");
    }
  }
  void positive(const char* name, int& value) {
    if (const Json* field = find(name, &Json::is_number_integer, "a whole number")) {
      const auto whole = field->get<double>();  // checked before the conversion to int
      if (!(whole > 0 && whole <= limits::kProfileCount))
        return fail(name, "must be greater than 0 and at most 100000");
      value = static_cast<int>(whole);
    }
  }
  void flag(const char* name, bool& value) {
    if (const Json* field = find(name, &Json::is_boolean, "true or false")) value = field->get<bool>();
  }
  void text(const char* name, std::string_view expected) {
    if (const Json* field = find(name, &Json::is_string, "a string")) {
      if (field->get<std::string>() != expected) fail(name, "must be \"" + std::string(expected) + "\"");
    }
  }
  void known(const char* name) { known_.insert(name); }
  /// The fields of a nested object.
  std::optional<Fields> part(const char* name) {
    const Json* field = find(name, &Json::is_object, "an object");
    if (field == nullptr) return std::nullopt;
    return Fields(*field, where_, pointer_ + "/" + name);
  }

  std::optional<Error> error() {
    for (const auto& [name, value] : json_.items()) {
      if (!known_.contains(name)) fail(name, "is not a field of a simulator profile");
    }
    return error_;
  }

 private:
  const Json* find(const char* name, bool (Json::*is_kind)() const noexcept, const char* kind) {
    known(name);
    const auto field = json_.find(name);
    if (field == json_.end()) {
      fail(name, std::string("is missing; expected ") + kind);
      return nullptr;
    }
    if (!((*field).*is_kind)()) {
      fail(name, std::string("must be ") + kind);
      return nullptr;
    }
    return &*field;
  }
  void fail(const std::string& name, const std::string& what) {
    if (!error_) error_ = Error{Error::Kind::Schema, where_, {}, pointer_ + "/" + name + " " + what};
  }

  const Json& json_;
  std::string where_, pointer_;
  std::set<std::string> known_;
  std::optional<Error> error_;
};

}  // namespace

Result<Profile> load_profile(const std::filesystem::path& folder, Simulator simulator, ActionProfile actions) {
  const auto path = folder / (std::string(name_of(simulator)) + ".json");
  const auto text = read_file(path);
  if (!text) return text.error();
  const auto json = parse_json(path.string(), *text);
  if (!json) return json.error();
  if (!json->is_object()) return Error{Error::Kind::Schema, path.string(), {}, "expected a JSON object"};
  Profile p;
  p.simulator = simulator;
  Fields fields(*json, path.string());
  fields.text("format", "unietp-simulator/1");
  fields.text("simulator", name_of(simulator));
  fields.known("sources");
  p.actions = actions_of(simulator, ActionProfile::Unietp);
  fields.positive("reach_m", p.reach_m);
  fields.positive("hands", p.hands);
  fields.positive("body_radius_m", p.body_radius_m);
  fields.positive("body_height_m", p.body_height_m);
  fields.positive("camera_height_m", p.camera_height_m);
  fields.positive("image_width", p.image_width);
  fields.positive("image_height", p.image_height);
  fields.positive("vertical_fov_deg", p.vertical_fov_deg);
  fields.positive("sight_m", p.sight_m);
  fields.positive("step_m", p.step_m);
  fields.positive("turn_deg", p.turn_deg);
  fields.positive("look_deg", p.look_deg);
  fields.positive("most_up_deg", p.most_up_deg);
  fields.positive("most_down_deg", p.most_down_deg);
  fields.positive("max_pick_mass_kg", p.max_pick_mass_kg);
  fields.flag("power_needs_closed", p.power_needs_closed);
  fields.flag("open_needs_power_off", p.open_needs_power_off);
  fields.flag("slicing", p.slicing);
  fields.flag("washing", p.washing);
  fields.flag("temperature", p.temperature);
  auto wide = fields.part("wide");
  if (const auto error = fields.error()) return *error;
  Profile w = p;  // always read, so that its errors are found
  w.actions = actions_of(simulator, ActionProfile::Wide);
  wide->flag("attaching", w.attaching);
  wide->flag("power_needs_plug", w.power_needs_plug);
  if (const auto error = wide->error()) return *error;
  return actions == ActionProfile::Wide ? w : p;
}

}  // namespace unietp
