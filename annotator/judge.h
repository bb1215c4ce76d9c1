#pragma once

#include <string>

#include "annotator/wording_task.h"
#include "core/result.h"
#include "llm/ask.h"

namespace unietp {

/// A request to a model for the goal formula of a text, over the scene's vocabulary. It contains the text, the language
/// and the names of objects, and nothing of the goal. `complaint`: what was wrong with the last answer, or "".
LlmRequest judging_request(const std::string& text, const WordingTask& task, const std::string& complaint);

/// The formula of its answer. Errors: Schema, when there is none; Parse, when it is no goal.
Result<Formula> judged(const LlmAnswer& answer);

}  // namespace unietp
