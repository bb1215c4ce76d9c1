#pragma once

#include <string>
#include <string_view>

#include "core/result.h"
#include "llm/exchange.h"

namespace unietp {

/// How the form of the answer is asked for.
enum class LlmForm { ResponseFormat, Words };

/// The body of a chat-completions request.
std::string chat_body(const LlmEndpoint& endpoint, const LlmRequest& request, LlmForm form);

/// Reads a chat completion. Errors: Schema, naming the place, when it is none, when its text holds no JSON object (cut
/// off by the length limit, perhaps), or when the object repeats the key.
Result<LlmAnswer> read_completion(std::string_view body, std::string_view key);

/// The tokens that a body says were used; 0 where it does not say.
LlmAnswer usage_in(std::string_view body);

/// What an error's body says, as one line without the key; "" when it says nothing that can be shown.
std::string complaint_in(std::string_view body, std::string_view key);

}  // namespace unietp
