#pragma once

#include <string>
#include <vector>

#include "annotator/wording_task.h"
#include "core/result.h"
#include "llm/ask.h"

namespace unietp {

/// A request to a model for an instruction: template, goal as a formula and in words, facts of the scene, style and
/// wordings of the grammar. `complaint`: why the last text was rejected, or "".
LlmRequest wording_request(const WordingTask& task, const std::vector<std::string>& samples,
                           const std::string& complaint);

/// The text of its answer, trimmed. Errors: Schema.
Result<std::string> worded(const LlmAnswer& answer);

}  // namespace unietp
