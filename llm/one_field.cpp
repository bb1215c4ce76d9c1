#include "llm/one_field.h"

#include <nlohmann/json.hpp>

namespace unietp {

using Json = nlohmann::json;

LlmRequest one_field_request(std::string system, std::string user, const std::string& field) {
  const Json schema = {{"type", "object"},
                       {"properties", {{field, {{"type", "string"}}}}},
                       {"required", Json::array({field})},
                       {"additionalProperties", false}};
  return {std::move(system), std::move(user), field, schema.dump(), {}, {}};
}

Result<std::string> field_of(const LlmAnswer& answer, const std::string& field) {
  const Json json = Json::parse(answer.text, nullptr, false);
  if (!json.is_object() || !json.contains(field) || !json.at(field).is_string())
    return Error{Error::Kind::Schema, "language model", {}, "expected a JSON object with the string '" + field + "'"};
  return json.at(field).get<std::string>();
}

}  // namespace unietp
