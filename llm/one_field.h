#pragma once

#include <string>

#include "core/result.h"
#include "llm/ask.h"

namespace unietp {

/// A request whose answer is an object of one string.
LlmRequest one_field_request(std::string system, std::string user, const std::string& field);

/// That string. Errors: Schema.
Result<std::string> field_of(const LlmAnswer& answer, const std::string& field);

}  // namespace unietp
