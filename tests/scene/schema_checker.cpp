#include "schema_checker.h"

#include <algorithm>
#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "core/files.h"
#include "core/text.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

/// Whether a text matches a pattern, which is an ECMAScript regular expression as JSON Schema has it.
bool matches(const std::string& text, const std::string& pattern) {
  return std::regex_search(text, std::regex(pattern, std::regex::ECMAScript));
}

}  // namespace

Json schema_file(const std::string& name) {
  const auto text = read_file(std::string(UNIETP_SOURCE_DIR) + "/data/schemas/" + name);
  EXPECT_TRUE(text);
  return text ? Json::parse(*text) : Json();
}

const Json& SchemaChecker::root(const std::string& file) {
  const auto [place, is_new] = files_.try_emplace(file);
  if (is_new) place->second = schema_file(file);
  return place->second;
}

std::string SchemaChecker::check(const Json& value, const Json& schema, const std::string& file,
                                 const std::string& path) {
  for (const auto& [word, rule] : schema.items()) {
    const std::string problem = broken(word, rule, value, schema, file, path);
    if (!problem.empty()) return problem;
  }
  return "";
}

std::string SchemaChecker::broken(const std::string& word, const Json& rule, const Json& value, const Json& schema,
                                  const std::string& file, const std::string& path) {
  static const std::set<std::string> silent{"$schema", "$id", "title", "description", "$defs", "properties"};
  const auto unless = [&](bool sound) {
    return sound ? std::string() : path + " breaks " + word + ": " + value.dump();
  };
  if (silent.contains(word)) return "";
  if (word == "$ref") {
    const auto parts = split(rule.get<std::string>(), '#');
    const std::string target = parts[0].empty() ? file : parts[0];
    return check(value, root(target).at(Json::json_pointer(parts[1])), target, path);
  }
  if (word == "anyOf") {
    const auto fits = [&](const Json& one) { return check(value, one, file, path).empty(); };
    return unless(std::any_of(rule.begin(), rule.end(), fits));
  }
  if (word == "type") {
    const std::string type = value.is_number() ? "number" : value.type_name();
    return unless(type == rule);
  }
  if (word == "const") return unless(value == rule);
  if (word == "enum") return unless(std::find(rule.begin(), rule.end(), value) != rule.end());
  if (word == "required") {
    for (const Json& name : rule) {
      if (!value.contains(name.get<std::string>())) return path + " lacks " + name.dump();
    }
    return "";
  }
  if (word == "additionalProperties") {
    const Json none = Json::object();
    const Json& known = schema.contains("properties") ? schema["properties"] : none;
    for (const auto& [name, field] : value.items()) {
      const bool has_own = known.contains(name);
      if (!has_own && rule == false) return path + " has the extra field " + name;
      const auto problem = check(field, has_own ? known[name] : rule, file, path + "/" + name);
      if (!problem.empty()) return problem;
    }
    return "";
  }
  if (word == "items") {
    for (std::size_t i = 0; i < value.size(); ++i) {
      const auto problem = check(value[i], rule, file, path + "/" + std::to_string(i));
      if (!problem.empty()) return problem;
    }
    return "";
  }
  if (word == "minItems") return unless(value.size() >= rule);
  if (word == "maxItems") return unless(value.size() <= rule);
  if (word == "uniqueItems") return unless(std::set<Json>(value.begin(), value.end()).size() == value.size());
  if (word == "minLength") return unless(!value.get<std::string>().empty());
  if (word == "maxLength") return unless(value.get<std::string>().size() <= rule);
  if (word == "minimum") return unless(value >= rule);
  if (word == "maximum") return unless(value <= rule);
  if (word == "exclusiveMinimum") return unless(value > rule);
  if (word == "pattern") return unless(matches(value.get<std::string>(), rule.get<std::string>()));
  return "the checker does not know " + word;
}

}  // namespace unietp
