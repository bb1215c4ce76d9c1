#include <nlohmann/json.hpp>

#include "bodies.h"
#include "fuzz_bodies.h"
#include "scene/json_parse.h"
#include "scene/scene_json.h"
#include "scene/start.h"
#include "support.h"

namespace unietp::fuzz {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const Json& json) { return json.dump(); }
std::string text_of(std::string text) { return text; }

/// Reads a part of a trace out of a text, and what is written of it, with positions checked.
template <class T, class Written>
std::optional<T> read_part(std::string_view text, Result<T> (*read)(std::string_view, const Json&),
                           Written (*write)(const T&)) {
  const auto json = parse_json("fuzz", text);
  if (!json) {
    check_error(json.error());
    return std::nullopt;
  }
  const auto value = read("fuzz", *json);
  if (!value) {
    check_error(value.error());
    return std::nullopt;
  }
  const std::string written = text_of(write(*value));
  const auto json_again = parse_json("fuzz", written);
  require(static_cast<bool>(json_again));
  const auto again = read("fuzz", *json_again);
  require(again && *again == *value);
  require(text_of(write(*again)) == written);
  return *value;
}

}  // namespace

bool scene_body(std::string_view text) {
  const auto scene = scene_from_json("fuzz", text);
  if (!scene) {
    check_error(scene.error());
    return false;
  }
  const std::string written = scene_to_json(*scene);
  const auto again = scene_from_json("fuzz", written);
  require(static_cast<bool>(again));
  require(*again == *scene);
  require(scene_to_json(*again) == written);
  require(difference(*scene, *again).empty());
  require(to_logic(*scene, {}, true).states.size() == 1);
  return true;
}

bool delta_body(std::string_view text) {
  const auto delta = read_part<Delta>(text, delta_from_json, delta_to_json);
  if (!delta) return false;
  const Scene whole = apply(Scene{}, *delta);
  const auto start = start_in("fuzz", whole, *delta, "start");
  if (start) {
    require(start->nodes.size() + delta->removed.size() == whole.nodes.size());
  } else {
    check_error(start.error());
  }
  return true;
}

bool action_body(std::string_view text) {
  const auto action = read_part<Action>(text, action_from_json, action_to_json);
  if (action) require(to_text(*action).starts_with(info(action->type).name));
  return action.has_value();
}

}  // namespace unietp::fuzz
