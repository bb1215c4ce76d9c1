#pragma once

#include "annotator/instruction.h"
#include "annotator/llm_client.h"

namespace unietp {

struct LlmWriterOptions {
  LlmEndpoint endpoint;
  int rewrites = 3;  // further tries after an answer that fails a check
};

/// As write_instruction, but an LLM words it. Each answer must pass check_instruction; one that fails goes back with
/// what is wrong; after the last, or when the endpoint does not answer, the grammar writes. Instruction.writer says who
/// wrote. Not deterministic where the endpoint is not.
Result<Instruction> write_instruction_with_llm(const Specification& specification, const Knowledge& knowledge,
                                               const LlmWriterOptions& options, Rng rng);

}  // namespace unietp
