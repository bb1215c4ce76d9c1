#include "dataset/configuration_json.h"

#include "core/limits.h"
#include "dataset/candidate_number.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/text.h"
#include "core/unknown_name.h"
#include "scene/json_parse.h"
#include "scene/json_reader.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kFormat = "unietp-run/1";

template <class T>
Json names_json(const std::vector<T>& values) {
  Json json = Json::array();
  for (const T value : values) json.push_back(name_of(value));
  return json;
}

template <class T>
Json shares_json(const std::vector<std::pair<T, int>>& shares) {
  Json json = Json::object();
  for (const auto& [value, count] : shares) json[std::string(name_of(value))] = count;
  return json;
}

/// Reads the fields of a configuration one after the other into it.
class ConfigurationReader {
 public:
  explicit ConfigurationReader(std::string_view where) : reader_(where) {}

  Result<RunConfiguration> read(const Json& json) {
    const JsonAt root{json};
    JsonFields fields(reader_, root);
    if (const auto at = fields.required("format"); at && reader_.text(*at) != kFormat)
      reader_.fail(*at, "expected \"" + std::string(kFormat) + "\"");
    RunConfiguration configuration;
    number(fields, "seed", 0, double{limits::kSeed}, configuration.seed);
    counted_ = number(fields, "count", 1, limits::kTasks, configuration.count);
    list(fields, "simulators", std::vector<Simulator>(kSimulators.begin(), kSimulators.end()), configuration.simulators,
         1);
    list(fields, "splits", all_splits(), configuration.splits);
    quotas(fields, configuration);
    if (const auto at = fields.optional("templates")) configuration.templates = reader_.texts(*at);
    if (const auto at = fields.optional("without")) configuration.without = reader_.texts(*at);
    if (const auto at = fields.optional("extended")) configuration.extended = reader_.boolean(*at);
    if (const auto at = fields.optional("native")) configuration.native = reader_.boolean(*at);
    if (const auto at = fields.optional("own")) configuration.own = reader_.texts(*at);
    binding(fields, configuration);
    list(fields, "modes", std::vector<Mode>(kModes.begin(), kModes.end()), configuration.modes, 1);
    if (configuration.modes.front() != Mode::M1) configuration.modes.insert(configuration.modes.begin(), Mode::M1);
    if (const auto at = fields.optional("phrasings"))
      configuration.phrasings = one_of(*at, std::vector<Phrasings>(kPhrasings.begin(), kPhrasings.end()));
    if (const auto at = fields.optional("english"))
      configuration.english = one_of(*at, std::vector<English>(kEnglishes.begin(), kEnglishes.end()));
    if (const auto at = fields.optional("sense")) {
      const auto grade = parse_sense("", reader_.text(*at));
      if (!grade) reader_.fail(*at, grade.error().message);
      if (grade) configuration.sense = *grade;
    }
    number(fields, "attempts", 1, limits::kAttempts, configuration.attempts);
    number(fields, "block", 1, 1e6, configuration.block);
    if (const auto at = fields.optional("homes"))
      configuration.homes = one_of(*at, std::vector<HomeSource>(kHomeSources.begin(), kHomeSources.end()));
    number(fields, "rooms", 5, 20, configuration.rooms);
    number(fields, "objects", 0, 1000, configuration.objects);
    if (const auto at = fields.optional("scenes")) configuration.scenes = reader_.texts(*at);
    fields.finish();
    if (reader_.error()) return *reader_.error();
    return configuration;
  }

 private:
  double whole(const JsonAt& at, double low, double high) {
    const double value = reader_.number(at);
    if (!reader_.error() && (value != std::floor(value) || value < low || value > high))
      reader_.fail(at, "expected a whole number from " + std::to_string(std::llround(low)) + " to " +
                           std::to_string(std::llround(high)));
    return reader_.error() ? low : value;
  }

  template <class T>
  bool number(JsonFields& fields, std::string_view name, double low, double high, T& value) {
    const auto at = fields.optional(name);
    if (at) value = static_cast<T>(whole(*at, low, high));
    return at.has_value();
  }

  template <class T>
  T one_of(std::string_view name, const JsonAt& at, const std::vector<T>& known) {
    std::vector<std::string> accepted;
    for (const T value : known) {
      if (name_of(value) == name) return value;
      accepted.emplace_back(name_of(value));
    }
    reader_.fail(at, unknown_name_error("", name, accepted).message);
    return known.front();
  }
  template <class T>
  T one_of(const JsonAt& at, const std::vector<T>& known) {
    const std::string name = reader_.text(at);
    return reader_.error() ? known.front() : one_of(name, at, known);
  }

  /// In the order of `known`, each once; `values` stay as they are where the list is left out or wrong.
  template <class T>
  void list(JsonFields& fields, std::string_view field, const std::vector<T>& known, std::vector<T>& values,
            std::size_t at_least = 0) {
    const auto at = fields.optional(field);
    if (!at) return;
    std::vector<T> asked;
    for (std::size_t i = 0; i < reader_.items(*at); ++i) asked.push_back(one_of(reader_.item(*at, i), known));
    if (asked.size() < at_least) reader_.fail(*at, "expected at least one name");
    if (reader_.error()) return;
    values.clear();
    for (const T value : known) {
      if (std::find(asked.begin(), asked.end(), value) != asked.end()) values.push_back(value);
    }
  }

  template <class T>
  void shares(JsonFields& fields, std::string_view field, const std::vector<T>& known,
              std::vector<std::pair<T, int>>& values) {
    const auto at = fields.required(field);
    if (!at) return;
    if (!at->json.is_object()) return reader_.fail(*at, "expected an object of names and integers");
    std::vector<std::pair<T, int>> read;
    for (const auto& [name, count] : at->json.items()) {
      const JsonAt item{count, &*at, name};
      const T value = one_of(std::string_view(name), item, known);
      read.emplace_back(value, static_cast<int>(whole(item, 0, limits::kTasks)));
    }
    for (const T value : known) {
      for (const auto& one : read) {
        if (one.first == value) values.push_back(one);
      }
    }
  }

  void quotas(JsonFields& fields, RunConfiguration& configuration) {
    const auto at = fields.optional("quotas");
    if (!at) return;
    Quotas& quotas = configuration.quotas;
    JsonFields own(reader_, *at);
    shares(own, "splits", all_splits(), quotas.splits);
    shares(own, "simulators", std::vector<Simulator>(kSimulators.begin(), kSimulators.end()), quotas.simulators);
    own.finish();
    const auto sum = [](const auto& all) {
      return std::accumulate(all.begin(), all.end(), std::int64_t{0},
                             [](std::int64_t so_far, const auto& one) { return so_far + one.second; });
    };
    const std::int64_t count = sum(quotas.splits);
    if (count > limits::kTasks) reader_.fail(*at, "ask for more than " + std::to_string(limits::kTasks) + " tasks");
    if (count != sum(quotas.simulators) || count < 1)
      reader_.fail(*at, "splits ask for " + std::to_string(count) + " tasks and simulators for " +
                            std::to_string(sum(quotas.simulators)) + "; both must sum to the same number, above 0");
    if (counted_ && configuration.count != count)
      reader_.fail(*at, "ask for " + std::to_string(count) + " tasks, but \"count\" says " +
                            std::to_string(configuration.count) + "; leave one of them out");
    if (reader_.error()) return;
    configuration.count = static_cast<int>(count);
    configuration.simulators.clear();
    for (const auto& one : quotas.simulators) configuration.simulators.push_back(one.first);
    configuration.splits.clear();
    for (const auto& one : quotas.splits) configuration.splits.push_back(one.first);
  }

  void binding(JsonFields& fields, RunConfiguration& configuration) {
    const auto at = fields.optional("binding");
    if (!at) return;
    for (const std::string& text : reader_.texts(*at)) {
      const auto sign = text.find('=');
      if (sign == std::string::npos || sign == 0 || sign + 1 == text.size())
        return reader_.fail(*at, "expected PLACEHOLDER=CATEGORY, not " + in_quotes(text));
      configuration.binding.emplace_back(text.substr(0, sign), text.substr(sign + 1));
    }
  }

  JsonReader reader_;
  bool counted_ = false;  // the file has a count of its own
};

}  // namespace

Json to_json(const RunConfiguration& configuration) {
  Json json{{"format", kFormat},
            {"seed", configuration.seed},
            {"count", configuration.count},
            {"simulators", names_json(configuration.simulators)},
            {"splits", names_json(configuration.splits)}};
  if (!configuration.quotas.empty())
    json["quotas"] = {{"splits", shares_json(configuration.quotas.splits)},
                      {"simulators", shares_json(configuration.quotas.simulators)}};
  json["templates"] = configuration.templates;
  if (!configuration.without.empty()) json["without"] = configuration.without;
  if (configuration.extended) json["extended"] = true;
  if (configuration.native) json["native"] = true;
  if (!configuration.own.empty()) json["own"] = configuration.own;
  if (!configuration.binding.empty()) {
    auto& binding = json["binding"] = Json::array();
    for (const auto& [placeholder, category] : configuration.binding) binding.push_back(placeholder + "=" + category);
  }
  json["modes"] = names_json(configuration.modes);
  json["phrasings"] = name_of(configuration.phrasings);
  json["english"] = name_of(configuration.english);
  json["sense"] = name_of_least(configuration.sense);
  json["attempts"] = configuration.attempts;
  json["block"] = configuration.block;
  json["homes"] = name_of(configuration.homes);
  json["rooms"] = configuration.rooms;
  json["objects"] = configuration.objects;
  if (!configuration.scenes.empty()) json["scenes"] = configuration.scenes;
  return json;
}

Result<RunConfiguration> configuration_from_json(std::string_view where, std::string_view text) {
  const auto json = parse_json(where, text);
  if (!json) return json.error();
  return ConfigurationReader(where).read(*json);
}

Result<RunConfiguration> read_configuration(const std::filesystem::path& file) {
  const auto text = read_file(file);
  if (!text) return text.error();
  return configuration_from_json(file.string(), *text);
}

}  // namespace unietp
