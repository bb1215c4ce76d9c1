#pragma once

#include <string>

#include "annotator/wording_task.h"
#include "core/result.h"
#include "llm/ask.h"

namespace unietp {

/// Asks a model what a text demands, as a goal formula over the scene's vocabulary. The request holds the text, the
/// language and the names of things, and nothing of the goal. `complaint`: what was wrong with its last answer, or "".
LlmRequest judging_request(const std::string& text, const WordingTask& task, const std::string& complaint);

/// The formula of its answer. Errors: Schema, when there is none; Parse, when it is no goal.
Result<Formula> judged(const LlmAnswer& answer);

}  // namespace unietp
