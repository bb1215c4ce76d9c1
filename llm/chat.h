#pragma once

#include <string>
#include <string_view>

#include "core/result.h"
#include "llm/exchange.h"

namespace unietp {

/// How the request asks for JSON: by response_format or in the prompt.
enum class LlmForm { ResponseFormat, Words };

/// The body of a chat-completions request.
std::string chat_body(const LlmEndpoint& endpoint, const LlmRequest& request, LlmForm form);

/// Reads a chat completion. Errors: Schema, with the position, when it is none, when its text holds no JSON object (cut
/// off by the length limit, perhaps), or when the object repeats the key.
Result<LlmAnswer> read_completion(std::string_view body, std::string_view key);

/// The token counts in a body; 0 where it has none.
LlmAnswer usage_in(std::string_view body);

/// The message in the body of an error, as one line without the key; "" when there is none.
std::string error_message_in(std::string_view body, std::string_view key);

}  // namespace unietp
