#pragma once

#include "annotator/instruction.h"
#include "llm/ask.h"

namespace unietp {

struct LlmWriterOptions {
  LlmEndpoint endpoint;
  LlmOptions ask;             // of each exchange; its seed is drawn from the writer's rng
  int rewrites = 3;           // further tries after an answer that fails a check
  LlmCache* cache = nullptr;  // may be null
};

/// As write_instruction, but an LLM words it. Each answer must pass check_instruction; one that fails goes back with
/// what is wrong; after the last, or when the endpoint does not answer, the grammar writes. Instruction.writer says who
/// wrote. Not deterministic where the endpoint is not and there is no cache.
Result<Instruction> write_instruction_with_llm(const Specification& specification, const Knowledge& knowledge,
                                               const LlmWriterOptions& options, Rng rng);

}  // namespace unietp
