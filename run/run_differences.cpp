#include "run/run_differences.h"

#include <set>

#include <nlohmann/json.hpp>

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kShown = 8;  // lines

std::string shown_value(const Json& flat, const std::string& at) {
  const auto found = flat.find(at);
  return found == flat.end() ? "nothing" : found->dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string run_differences(const std::string& was, const std::string& is) {
  const auto before = Json::parse(was, nullptr, false), now = Json::parse(is, nullptr, false);
  if (!before.is_object() || !now.is_object()) return "\n  it was: " + was + "\n  it is:  " + is;
  const Json old_values = before.flatten(), new_values = now.flatten();
  std::set<std::string> names;
  for (const Json* values : {&old_values, &new_values})
    for (const auto& [name, value] : values->items()) names.insert(name);
  std::string text;
  std::size_t count = 0;
  for (const auto& name : names) {
    const auto old_value = shown_value(old_values, name), new_value = shown_value(new_values, name);
    if (old_value == new_value || ++count > kShown) continue;
    text += "\n  " + name + " was " + old_value + " and is " + new_value;
  }
  if (count > kShown) text += "\n  and " + std::to_string(count - kShown) + " more";
  return text;
}

}  // namespace unietp
