#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/limits.h"
#include "core/result.h"
#include "llm/ask.h"

namespace unietp {

// Files of a provider's batch service: JSON lines, one request or answer a line, each answer with the `custom_id` of
// its request. A request's id is its digest, so that equal requests are one and answers find their requests in any
// later run.

/// The endpoint for the digests of batch requests, which name a path and no host.
LlmEndpoint batch_endpoint(std::string model);

/// One line, without its end. The key is no part of it.
std::string batch_line(const LlmEndpoint& endpoint, const LlmRequest& request);

/// The id of a request line, or "" when the line is none.
std::string id_of_batch_line(std::string_view line);

/// Lines cut into files of at most so many lines and bytes.
std::vector<std::string> batch_files(const std::vector<std::string>& lines,
                                     std::size_t most_lines = limits::kBatchLines,
                                     std::size_t most_bytes = limits::kBatchBytes);

/// Answers by request id, in whatever order and files they came. An answer wins over a failure for the same request.
struct BatchAnswers {
  std::map<std::string, Result<LlmAnswer>> by_id;  // errors: Io, what the service says; Schema, no usable answer
  std::map<std::string, int> failures;             // number of failures by request
  std::vector<Error> unreadable;                   // lines that cannot be read, with file and line
};
/// Adds the answers of a file's text; `where` names it in errors.
void read_batch_answers(std::string_view where, std::string_view text, BatchAnswers& into);

}  // namespace unietp
