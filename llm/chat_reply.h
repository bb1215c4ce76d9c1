#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/result.h"

namespace unietp {

/// What a model answered to a chat, whatever it says. Texts are UTF-8 and hold no key.
struct ChatReply {
  std::string text;      // after its reasoning
  std::string thinking;  // what the server gives apart from the text, or stands before `</think>` in it
  std::string finish;    // "stop", "length" (cut by the limit of tokens), …; "" when the server does not say
  std::string model;     // that answered, as the server names it; "" when it does not
  std::int64_t prompt_tokens = 0, completion_tokens = 0;  // 0 when the server does not count
  bool operator==(const ChatReply&) const = default;
};

/// Reads a chat completion. Its text may be anything, also empty. Errors: Schema, when the body is no chat completion.
Result<ChatReply> read_chat_reply(std::string_view body, std::string_view key);

/// A reply as JSON text, for the cache, and back. Errors of reading: Schema.
std::string to_text(const ChatReply& reply);
Result<ChatReply> read_stored_reply(std::string_view text);

}  // namespace unietp
