#include "llm/chat_reply.h"

#include <nlohmann/json.hpp>

#include "llm/chat.h"
#include "llm/foreign_json.h"
#include "llm/redact.h"

namespace unietp {
namespace {

using Json = nlohmann::json;

/// The text of a message's content: a text, or the texts of its parts.
std::string text_of(const Json& content) {
  if (content.is_string()) return content.get<std::string>();
  std::string text;
  if (!content.is_array()) return text;
  for (const Json& part : content) text += text_at(part, "/text");
  return text;
}

/// Takes what stands before the last `</think>`, and the mark that opens it, out of a text.
std::string take_thinking(std::string& text) {
  constexpr std::string_view kOpen = "<think>", kClose = "</think>";
  const auto close = text.rfind(kClose);
  std::string thinking;
  if (close != std::string::npos) {
    thinking = text.substr(0, close);
    text.erase(0, close + kClose.size());
  } else if (text.find_first_not_of(" \n\r\t") != std::string::npos &&
             text.compare(text.find_first_not_of(" \n\r\t"), kOpen.size(), kOpen) == 0) {
    thinking = std::move(text);  // cut before it came to an answer
    text.clear();
  }
  if (const auto open = thinking.find(kOpen); open != std::string::npos) thinking.erase(open, kOpen.size());
  return thinking;
}

Error no_completion(const std::string& message) { return {Error::Kind::Schema, "chat completion", {}, message}; }

}  // namespace

Result<ChatReply> read_chat_reply(std::string_view body, std::string_view key) {
  const Json outer = foreign_json(body);
  if (!outer.is_object()) return no_completion("expected a JSON object");
  const Json::json_pointer place("/choices/0/message");
  if (!outer.contains(place) || !outer.at(place).is_object()) return no_completion("expected /choices/0/message");
  const Json& message = outer.at(place);
  ChatReply reply;
  reply.text = text_of(message.value("content", Json()));
  for (const char* field : {"/reasoning_content", "/reasoning"}) {
    if (reply.thinking.empty()) reply.thinking = text_at(message, field);
  }
  if (reply.thinking.empty()) reply.thinking = take_thinking(reply.text);
  reply.finish = plain_line(text_at(outer, "/choices/0/finish_reason"), kLongestErrorMessage);
  reply.model = plain_line(redacted(text_at(outer, "/model"), key), kLongestErrorMessage);
  reply.text = redacted(reply.text, key);
  reply.thinking = redacted(reply.thinking, key);
  const LlmAnswer usage = usage_in(body);
  reply.prompt_tokens = usage.prompt_tokens;
  reply.completion_tokens = usage.completion_tokens;
  return reply;
}

std::string to_text(const ChatReply& reply) {
  return Json{
      {"text", reply.text},   {"thinking", reply.thinking},           {"finish", reply.finish},
      {"model", reply.model}, {"prompt_tokens", reply.prompt_tokens}, {"completion_tokens", reply.completion_tokens}}
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<ChatReply> read_stored_reply(std::string_view text) {
  const Json json = foreign_json(text);
  for (const char* field : {"text", "thinking", "finish", "model"}) {
    if (!json.is_object() || !json.contains(field) || !json[field].is_string())
      return no_completion("expected the stored reply to have \"" + std::string(field) + "\"");
  }
  ChatReply reply{json["text"], json["thinking"], json["finish"], json["model"], 0, 0};
  const auto count = [&](const char* field) {
    return json.contains(field) && json[field].is_number_integer() ? json[field].get<std::int64_t>() : 0;
  };
  reply.prompt_tokens = count("prompt_tokens");
  reply.completion_tokens = count("completion_tokens");
  return reply;
}

}  // namespace unietp
