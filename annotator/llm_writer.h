#pragma once

#include <functional>
#include <vector>

#include "annotator/instruction.h"
#include "annotator/wording_task.h"
#include "llm/ask.h"

namespace unietp {

/// Answers requests, in their order: `ask_all` at an endpoint, or the answers of batch files.
using LlmBatchCall = std::function<std::vector<Result<LlmAnswer>>(const std::vector<LlmRequest>&)>;

/// The model and the grammar behind it.
struct LlmWriterOptions {
  LlmBatchCall ask;
  std::string model;                          // for Instruction::writer
  int rewrites = 2;                           // further attempts for a task whose text was rejected
  Phrasings phrasings = Phrasings::Everyday;  // of the grammar's texts: examples in prompts, and the fallback
};

/// Has a language model word all tasks, several requests at a time. Each text must pass the checks of word_check.h and
/// spelling.h, have the features of its style, and be read by a second, separate call (judge.h) as a formula equivalent
/// to the goal. A text that fails is sent back with its faults; after the last attempt, or without an answer, the
/// grammar's text is used, and `Instruction::why` says why. In the order of the tasks;
/// deterministic in the answers, whatever their order of arrival. Errors, of single tasks: those of write_instruction
/// and of Spelling::open.
std::vector<Result<Instruction>> write_instructions_with_llm(const std::vector<WordingTask>& tasks,
                                                             const LlmWriterOptions& options);

/// The requests of the first round, for display.
std::vector<LlmRequest> first_requests(const std::vector<WordingTask>& tasks, const LlmWriterOptions& options);

}  // namespace unietp
