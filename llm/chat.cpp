#include "llm/chat.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/limits.h"
#include "llm/foreign_json.h"
#include "llm/json_object.h"
#include "llm/redact.h"

namespace unietp {
namespace {

using Json = nlohmann::json;
using Pointer = Json::json_pointer;

std::int64_t count_at(const Json& json, const char* pointer) {
  const Pointer at(pointer);
  if (!json.contains(at) || !json.at(at).is_number_integer()) return 0;
  return std::clamp<std::int64_t>(json.at(at).get<std::int64_t>(), 0, limits::kAnswerTokens);
}

/// Checks parsed strings, since a server may write the key with escapes.
bool repeats(const Json& json, std::string_view key) {
  if (key.empty()) return false;
  if (json.is_string()) return json.get_ref<const std::string&>().find(key) != std::string::npos;
  if (json.is_object()) {
    return std::any_of(json.items().begin(), json.items().end(), [&](const auto& item) {
      return item.key().find(key) != std::string::npos || repeats(item.value(), key);
    });
  }
  return json.is_array() &&
         std::any_of(json.begin(), json.end(), [&](const Json& element) { return repeats(element, key); });
}

Error schema_error(const std::string& message) {
  return {Error::Kind::Schema, "chat completion /choices/0/message/content", {}, message};
}

}  // namespace

std::string chat_body(const LlmEndpoint& endpoint, const LlmRequest& request, LlmForm form) {
  std::string system = request.system;
  if (form == LlmForm::Words) {
    system += "\nAnswer with one JSON object and nothing else. It must follow this JSON schema:\n" + request.schema;
  }
  Json body = {{"model", endpoint.model},
               {"messages", Json::array({{{"role", "system"}, {"content", system}},
                                         {{"role", "user"}, {"content", request.user}}})}};
  if (form == LlmForm::ResponseFormat) {
    body["response_format"] = {
        {"type", "json_schema"},
        {"json_schema",
         {{"name", request.name}, {"strict", true}, {"schema", Json::parse(request.schema, nullptr, false)}}}};
  }
  if (request.temperature) body["temperature"] = *request.temperature;
  if (request.max_tokens) body["max_tokens"] = *request.max_tokens;
  return body.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<LlmAnswer> read_completion(std::string_view body, std::string_view key) {
  const Json outer = foreign_json(body);
  if (!outer.is_object()) return Error{Error::Kind::Schema, "chat completion", {}, "expected a JSON object"};
  const Pointer content("/choices/0/message/content");
  if (!outer.contains(content) || !outer.at(content).is_string()) return schema_error("expected a text");
  auto object = json_object_in(outer.at(content).get_ref<const std::string&>());
  if (!object) {
    const bool cut = text_at(outer, "/choices/0/finish_reason") == "length";
    return schema_error(std::string("expected a JSON object") + (cut ? "; the answer was cut off by its limit" : ""));
  }
  if (repeats(foreign_json(*object), key)) return schema_error("the answer repeats the key, so it is not used");
  LlmAnswer answer = usage_in(body);
  answer.text = std::move(*object);
  return answer;
}

LlmAnswer usage_in(std::string_view body) {
  const Json outer = foreign_json(body);
  LlmAnswer usage;
  usage.prompt_tokens = count_at(outer, "/usage/prompt_tokens");
  usage.completion_tokens = count_at(outer, "/usage/completion_tokens");
  return usage;
}

std::string error_message_in(std::string_view body, std::string_view key) {
  const Json outer = foreign_json(body);
  for (const char* place : {"/error/message", "/error", "/message", "/detail"}) {
    const auto message = text_at(outer, place);
    if (!message.empty()) return plain_line(redacted(message, key), kLongestErrorMessage);
  }
  return {};
}

}  // namespace unietp
