#include "environment/settings.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>

#include <nlohmann/json.hpp>

#include "core/limits.h"
#include "core/unknown_name.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

Error setting_error(std::string_view where, const std::string& name, std::string message) {
  return {
      Error::Kind::Usage, std::string(where.empty() ? "" : std::string(where) + ": ") + name, {}, std::move(message)};
}

/// One setting: how it is written and how it is read. `read` gives "" or what was expected.
struct SettingRow {
  const char* name;
  std::function<Json(const Settings&)> write;
  std::function<std::string(Settings&, const Json&)> read;
};

template <class Member>
SettingRow switch_row(const char* name, Member member) {
  return {name, [member](const Settings& s) { return Json(member(s)); },
          [member](Settings& s, const Json& json) -> std::string {
            if (!json.is_boolean()) return "expected true or false";
            member(s) = json.get<bool>();
            return "";
          }};
}

template <class Member>
SettingRow number_row(const char* name, Member member) {
  return {name, [member](const Settings& s) { return Json(member(s)); },
          [member](Settings& s, const Json& json) -> std::string {
            constexpr std::int64_t kMost = std::numeric_limits<int>::max();
            if (!json.is_number_integer() || json.get<std::int64_t>() < 0 || json.get<std::int64_t>() > kMost)
              return "expected a whole number from 0 on";
            member(s) = json.get<int>();
            return "";
          }};
}

/// A setting with one of some named values.
template <class Value, std::size_t N, class Member>
SettingRow choice_row(const char* name, const std::array<Value, N>& values, Member member) {
  return {name, [member](const Settings& s) { return Json(name_of(member(s))); },
          [member, &values](Settings& s, const Json& json) -> std::string {
            std::string accepted;
            for (const Value value : values) {
              if (json.is_string() && json.get_ref<const std::string&>() == name_of(value)) {
                member(s) = value;
                return "";
              }
              accepted += (accepted.empty() ? "" : ", ") + std::string(name_of(value));
            }
            return "expected one of " + accepted;
          }};
}

SettingRow invalid_row() {
  return {"invalid", [](const Settings& s) { return Json(s.rules.invalid_is_free ? "free" : "counts"); },
          [](Settings& s, const Json& json) -> std::string {
            if (json != "free" && json != "counts") return "expected one of counts, free";
            s.rules.invalid_is_free = json == "free";
            return "";
          }};
}

const std::vector<SettingRow>& setting_rows() {
  static const std::vector<SettingRow> kRows{
      choice_row(
          "mode", kModes, [](auto& s) -> auto& { return s.rules.mode; }),
      choice_row(
          "conventions", kConventions, [](auto& s) -> auto& { return s.conventions; }),
      switch_row(
          "picture", [](auto& s) -> auto& { return s.rules.picture; }),
      switch_row(
          "boxes", [](auto& s) -> auto& { return s.rules.boxes; }),
      switch_row(
          "rooms", [](auto& s) -> auto& { return s.rules.rooms; }),
      switch_row(
          "furniture", [](auto& s) -> auto& { return s.rules.furniture; }),
      switch_row(
          "movables", [](auto& s) -> auto& { return s.rules.movables; }),
      choice_row(
          "teleport", kTeleports, [](auto& s) -> auto& { return s.rules.teleport; }),
      choice_row(
          "reach", kNamings, [](auto& s) -> auto& { return s.rules.reach; }),
      switch_row(
          "move", [](auto& s) -> auto& { return s.rules.move; }),
      choice_row(
          "atomic", kNamings, [](auto& s) -> auto& { return s.rules.atomic; }),
      choice_row(
          "composite", kNamings, [](auto& s) -> auto& { return s.rules.composite; }),
      number_row(
          "steps", [](auto& s) -> auto& { return s.rules.limits.steps; }),
      number_row(
          "failures", [](auto& s) -> auto& { return s.rules.limits.failures; }),
      invalid_row(),
      choice_row(
          "feedback", kFeedbacks, [](auto& s) -> auto& { return s.feedback; }),
      choice_row(
          "reward", kRewards, [](auto& s) -> auto& { return s.reward; }),
      choice_row(
          "on_fail", kOnFails, [](auto& s) -> auto& { return s.on_fail; }),
      choice_row(
          "global", kGlobalForms, [](auto& s) -> auto& { return s.global; }),
      switch_row(
          "floor_plan", [](auto& s) -> auto& { return s.floor_plan; }),
      choice_row(
          "box_form", kBoxForms, [](auto& s) -> auto& { return s.box_form; }),
      number_row(
          "image_width", [](auto& s) -> auto& { return s.image_width; }),
      number_row(
          "image_height", [](auto& s) -> auto& { return s.image_height; }),
  };
  return kRows;
}

template <std::size_t N, class Value>
std::string_view name_among(const std::array<std::string_view, N>& names, Value value) {
  return names[static_cast<std::size_t>(value)];
}

/// The preset that JSON settings begin with.
Result<Settings> preset_of(std::string_view where, const Json& json) {
  Settings preset;
  for (const char* name : {"mode", "conventions"}) {
    const auto field = json.find(name);
    if (field == json.end()) continue;
    for (const SettingRow& row : setting_rows()) {
      if (std::string_view(row.name) != name) continue;
      if (auto wrong = row.read(preset, *field); !wrong.empty()) return setting_error(where, name, std::move(wrong));
    }
  }
  return settings_for(preset.rules.mode, preset.conventions);
}

}  // namespace

std::string_view name_of(Teleport teleport) {
  static constexpr std::array<std::string_view, 4> kNames{"nothing", "rooms", "furniture", "anything"};
  return name_among(kNames, teleport);
}
std::string_view name_of(Naming naming) {
  static constexpr std::array<std::string_view, 3> kNames{"none", "id", "box"};
  return name_among(kNames, naming);
}
std::string_view name_of(Feedback feedback) {
  static constexpr std::array<std::string_view, 3> kNames{"full", "success", "none"};
  return name_among(kNames, feedback);
}
std::string_view name_of(Reward reward) {
  static constexpr std::array<std::string_view, 2> kNames{"success", "progress"};
  return name_among(kNames, reward);
}
std::string_view name_of(Conventions conventions) {
  static constexpr std::array<std::string_view, 2> kNames{"paper", "release"};
  return name_among(kNames, conventions);
}
std::string_view name_of(OnFail on_fail) {
  static constexpr std::array<std::string_view, 2> kNames{"continue", "stop"};
  return name_among(kNames, on_fail);
}
std::string_view name_of(GlobalForm form) {
  static constexpr std::array<std::string_view, 2> kNames{"list", "by_room"};
  return name_among(kNames, form);
}
std::string_view name_of(BoxForm form) {
  static constexpr std::array<std::string_view, 4> kNames{"pixels", "unit", "thousand", "thousand_y_first"};
  return name_among(kNames, form);
}

Settings settings_for(Mode mode, Conventions conventions) {
  Settings settings;
  settings.rules = rules_of(mode);
  settings.conventions = conventions;
  settings.floor_plan = mode != Mode::M1 && conventions == Conventions::Paper;
  if (conventions == Conventions::Release) {
    settings.rules.invalid_is_free = true;
    settings.box_form = BoxForm::Unit;
  }
  return settings;
}

Result<Done> check(const Settings& settings) {
  const StepLimits& limits = settings.rules.limits;
  if (limits.steps < 1 || limits.steps > limits::kEpisodeSteps)
    return setting_error("", "steps", "expected 1 to " + std::to_string(limits::kEpisodeSteps));
  if (limits.failures < 1 || limits.failures > limits::kEpisodeSteps)
    return setting_error("", "failures", "expected 1 to " + std::to_string(limits::kEpisodeSteps));
  for (const auto& [name, pixels] :
       {std::pair("image_width", settings.image_width), std::pair("image_height", settings.image_height)}) {
    if (pixels != 0 && (pixels < limits::kLeastImageSide || pixels > limits::kImageSide))
      return setting_error("", name,
                           "expected 0, or " + std::to_string(limits::kLeastImageSide) + " to " +
                               std::to_string(limits::kImageSide) + " pixels");
  }
  if (settings.global == GlobalForm::ByRoom && !settings.rules.rooms)
    return setting_error("", "global", "by_room tells the rooms; expected list where rooms is false");
  if (settings.feedback == Feedback::None && settings.rules.invalid_is_free)
    return setting_error("", "invalid", "free shows in steps_left what failed; with feedback none expected counts");
  if (settings.feedback == Feedback::None && settings.on_fail == OnFail::Stop)
    return setting_error("", "on_fail", "stop shows in steps_left what failed; with feedback none expected continue");
  return Done{};
}

const std::vector<std::string>& setting_names() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names;
    for (const SettingRow& row : setting_rows()) names.emplace_back(row.name);
    return names;
  }();
  return kNames;
}

Json settings_to_json(const Settings& settings) {
  Json json = Json::object();
  for (const SettingRow& row : setting_rows()) json[row.name] = row.write(settings);
  return json;
}

Result<Settings> settings_from_json(std::string_view where, const Json& json) {
  if (!json.is_object()) return setting_error(where, "settings", "expected a JSON object");
  for (const auto& [name, value] : json.items()) {
    const auto& known = setting_names();
    if (std::find(known.begin(), known.end(), name) == known.end())
      return unknown_name_error(std::string(where.empty() ? "settings" : where), name, known);
  }
  auto settings = preset_of(where, json);
  if (!settings) return settings;
  for (const SettingRow& row : setting_rows()) {
    const auto field = json.find(row.name);
    if (field == json.end()) continue;
    if (auto wrong = row.read(*settings, *field); !wrong.empty())
      return setting_error(where, row.name, std::move(wrong));
  }
  if (auto fine = check(*settings); !fine) return fine.error();
  return settings;
}

}  // namespace unietp
