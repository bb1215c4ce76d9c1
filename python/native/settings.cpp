#include "environment/settings.h"

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <nlohmann/json.hpp>

#include "python/native/bindings.h"
#include "python/native/failure.h"
#include "python/native/settings_text.h"
#include "scene/json_parse.h"

namespace nb = nanobind;
using namespace nb::literals;

namespace unietp::python {

Settings settings_of(const std::string& json) {
  return value_of(settings_from_json("settings", value_of(parse_json("settings", json))));
}

void define_settings(nb::module_& module) {
  module.def(
      "complete_settings", [](const std::string& json) { return settings_to_json(settings_of(json)).dump(); }, "json"_a,
      "All settings of an environment as JSON: those given, over the preset of \"mode\" and \"conventions\".\n"
      "Raises Error for an unknown name or value.");
  module.def(
      "offered_actions",
      [](const std::string& json, bool extended) {
        const auto rules = settings_of(json).rules;
        std::vector<std::string> names;
        for (const auto& action : all_actions()) {
          if (offers(action, rules)) names.emplace_back(action.name);
        }
        if (!extended) return names;
        for (const auto& action : extension_actions()) {
          if (offers(action, rules)) names.emplace_back(action.name);
        }
        return names;
      },
      "settings"_a, "extended"_a,
      "Names of the actions that the settings offer in some simulator, in the order of docs/actions.md.");
  module.def(
      "failure_names",
      [] {
        std::vector<std::string> names;
        for (std::size_t i = 0; i < kFailureCount; ++i) names.emplace_back(name_of(static_cast<Failure>(i)));
        return names;
      },
      "Names of the ways to fail, by number; the first is none.");
}

}  // namespace unietp::python
