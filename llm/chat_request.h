#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"

namespace unietp {

/// A turn of a chat. Pictures come before its text; shared, since later requests send them again.
struct ChatTurn {
  enum class Role { System, User, Assistant };
  Role role = Role::User;
  std::string text;
  std::vector<std::shared_ptr<const std::string>> pictures;  // PNG files
};

/// A chat of several turns whose answer is any text. Everything here shapes the answer.
struct ChatRequest {
  std::vector<ChatTurn> turns;
  std::optional<double> temperature, top_p;
  std::optional<int> max_tokens;
  std::optional<std::uint64_t> seed;
  std::string extra = "{}";  // further fields of the body: a JSON object that `check_extra` accepts
  std::string schema;        // JSON schema that the server is asked to keep to; "": none
};

/// The body of a chat-completions request. Equal requests give equal bytes.
std::string chat_body(const std::string& model, const ChatRequest& request);

/// Key of the answer in a cache or log: SHA-256 of the body and of which repeat it is, so that repeats are asked anew.
std::string digest_of(const std::string& body, int repeat);

/// The text as a JSON object in compact form. Errors: Usage, when it is none, or sets a field that the request itself
/// sets (model, messages, …) or that changes the form of the answer (stream, n).
Result<std::string> check_extra(const std::string& text);

}  // namespace unietp
