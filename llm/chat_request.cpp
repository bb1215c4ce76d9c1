#include "llm/chat_request.h"

#include <array>

#include <nlohmann/json.hpp>

#include "core/base64.h"
#include "core/digest.h"
#include "llm/foreign_json.h"

namespace unietp {
namespace {

using Json = nlohmann::json;

Json content_of(const ChatTurn& turn) {
  if (turn.pictures.empty()) return turn.text;
  Json parts = Json::array();
  for (const auto& picture : turn.pictures)
    parts.push_back({{"type", "image_url"}, {"image_url", {{"url", "data:image/png;base64," + base64(*picture)}}}});
  if (!turn.text.empty()) parts.push_back({{"type", "text"}, {"text", turn.text}});
  return parts;
}

const char* name_of(ChatTurn::Role role) {
  switch (role) {
    case ChatTurn::Role::System:
      return "system";
    case ChatTurn::Role::User:
      return "user";
    case ChatTurn::Role::Assistant:
      return "assistant";
  }
  return "";
}

}  // namespace

std::string chat_body(const std::string& model, const ChatRequest& request) {
  Json body = Json::parse(request.extra);
  body["model"] = model;
  Json& messages = body["messages"] = Json::array();
  for (const ChatTurn& turn : request.turns)
    messages.push_back({{"role", name_of(turn.role)}, {"content", content_of(turn)}});
  if (request.temperature) body["temperature"] = *request.temperature;
  if (request.top_p) body["top_p"] = *request.top_p;
  if (request.max_tokens) body["max_tokens"] = *request.max_tokens;
  if (request.seed) body["seed"] = *request.seed;
  if (!request.schema.empty()) {
    body["response_format"] = {
        {"type", "json_schema"},
        {"json_schema", {{"name", "answer"}, {"strict", true}, {"schema", Json::parse(request.schema)}}}};
  }
  return body.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string digest_of(const std::string& body, int repeat) {
  return sha256("unietp-chat/1 " + std::to_string(repeat) + " " + body);
}

Result<std::string> check_extra(const std::string& text) {
  const auto refused = [](const std::string& message) {
    return Error{Error::Kind::Usage, "extra fields", {}, message};
  };
  const Json json = foreign_json(text);
  if (!json.is_object()) return refused("expected a JSON object such as {\"min_p\": 0.1}");
  constexpr std::array kTaken{"model", "messages",        "temperature", "top_p", "max_tokens",
                              "seed",  "response_format", "stream",      "n"};
  for (const char* field : kTaken) {
    if (json.contains(field)) return refused("\"" + std::string(field) + "\" cannot be set here");
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace unietp
