#include "llm/foreign_json.h"

#include <nlohmann/json.hpp>

#include "llm/json_object.h"

namespace unietp {

using Json = nlohmann::json;

Json foreign_json(std::string_view text) {
  return nested_too_deep(text) ? Json(Json::value_t::discarded) : Json::parse(text, nullptr, false);
}

std::string text_at(const Json& json, const char* pointer) {
  const Json::json_pointer at(pointer);
  return json.contains(at) && json.at(at).is_string() ? json.at(at).get<std::string>() : std::string();
}

}  // namespace unietp
