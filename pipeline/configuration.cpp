#include "pipeline/configuration.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "core/text.h"

namespace unietp {
namespace {

std::vector<std::string> names(std::string_view text) {
  std::vector<std::string> all;
  for (const auto& part : split(text, ',')) {
    if (const auto name = trim(part); !name.empty()) all.emplace_back(name);
  }
  return all;
}

template <class T>
Result<std::vector<T>> parse_names(std::string_view option, std::string_view text, const std::vector<T>& known) {
  std::vector<std::string> accepted;
  for (const T value : known) accepted.emplace_back(name_of(value));
  const auto asked = names(text);
  if (asked.empty())
    return Error{Error::Kind::Usage, std::string(option), {}, "is empty; accepted: " + join(accepted, ", ")};
  for (const auto& name : asked) {
    if (std::find(accepted.begin(), accepted.end(), name) == accepted.end())
      return unknown_name_error(option, name, accepted);
  }
  std::vector<T> values;
  for (const T value : known) {
    if (std::find(asked.begin(), asked.end(), name_of(value)) != asked.end()) values.push_back(value);
  }
  return values;
}

}  // namespace

nlohmann::ordered_json to_json(const RunConfiguration& configuration) {
  auto simulators = nlohmann::ordered_json::array();
  for (const auto simulator : configuration.simulators) simulators.push_back(name_of(simulator));
  auto splits = nlohmann::ordered_json::array();
  for (const auto split : configuration.splits) splits.push_back(name_of(split));
  nlohmann::ordered_json json{{"count", configuration.count},       {"simulators", std::move(simulators)},
                              {"splits", std::move(splits)},        {"templates", configuration.templates},
                              {"attempts", configuration.attempts}, {"rooms", configuration.rooms},
                              {"objects", configuration.objects}};
  if (configuration.modes.size() > 1) {
    auto& modes = json["modes"] = nlohmann::ordered_json::array();
    for (const auto mode : configuration.modes) modes.push_back(name_of(mode));
  }
  if (configuration.extended) json["extended"] = true;
  if (!configuration.own.empty()) json["own"] = configuration.own;
  if (!configuration.binding.empty()) {
    auto& binding = json["binding"] = nlohmann::ordered_json::array();
    for (const auto& [placeholder, category] : configuration.binding) binding.push_back(placeholder + "=" + category);
  }
  if (!configuration.scenes.empty()) json["scenes"] = configuration.scenes;
  return json;
}

const std::vector<Split>& all_splits() {
  static const std::vector<Split> kSplits{Split::Atomic, Split::Compositional, Split::Logical, Split::InstanceGrounding,
                                          Split::Linguistic};
  return kSplits;
}

Result<std::vector<Simulator>> parse_simulators(std::string_view option, std::string_view text) {
  return parse_names(option, text, std::vector<Simulator>{kSimulators.begin(), kSimulators.end()});
}

Result<std::vector<Split>> parse_splits(std::string_view option, std::string_view text) {
  return parse_names(option, text, all_splits());
}

Result<std::vector<Mode>> parse_modes(std::string_view option, std::string_view text) {
  auto modes = parse_names(option, text, std::vector<Mode>{kModes.begin(), kModes.end()});
  if (modes && modes->front() != Mode::M1) modes->insert(modes->begin(), Mode::M1);
  return modes;
}

Error unknown_name_error(std::string_view option, std::string_view name, const std::vector<std::string>& accepted) {
  std::string message = "unknown name \"" + std::string(name) + "\"";
  if (const auto near = nearest_name(name, accepted); !near.empty()) message += ", did you mean \"" + near + "\"";
  return {Error::Kind::Usage, std::string(option), {}, message + "; accepted: " + join(accepted, ", ")};
}

}  // namespace unietp
