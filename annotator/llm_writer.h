#pragma once

#include <functional>
#include <vector>

#include "annotator/instruction.h"
#include "annotator/wording_task.h"
#include "llm/ask.h"

namespace unietp {

/// Gives an answer for each request, in their order: `ask_all` at an endpoint, or the answers of batch files.
using Asker = std::function<std::vector<Result<LlmAnswer>>(const std::vector<LlmRequest>&)>;

struct LlmWriterOptions {
  Asker ask;
  std::string model;  // stands in Instruction::writer
  int rewrites = 2;   // further tries of a task whose text was refused
  Phrasings phrasings =
      Phrasings::All;  // of the grammar's texts: those that a prompt shows, and the one that stands in
};

/// Has a language model word all tasks, many requests at once. Each text must pass the checks of word_check.h, be
/// spelt right (spelling.h), keep the promise of its style, and be read by a second, separate call (judge.h) as a
/// formula that is equivalent to the goal. A text that fails goes back with what is wrong; after the last try, or when
/// no answer comes, the grammar's text stands in, and `Instruction::why` says why. In the order of the tasks;
/// deterministic in the answers, whatever their order of arrival. Errors, of single tasks: those of write_instruction
/// and of Spelling::open.
std::vector<Result<Instruction>> write_instructions_with_llm(const std::vector<WordingTask>& tasks,
                                                             const LlmWriterOptions& options);

/// The requests of the first round, for people to look at.
std::vector<LlmRequest> first_requests(const std::vector<WordingTask>& tasks, const LlmWriterOptions& options);

}  // namespace unietp
