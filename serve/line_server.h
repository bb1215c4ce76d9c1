#pragma once

#include <atomic>
#include <cstddef>
#include <cstdio>

#include "serve/protocol.h"

namespace unietp {

/// Answers requests, one a line, with a line each, until the input ends, the output is closed, or `stop` is true, which
/// it notices within half a second. Lines of more than `line_bytes` are answered with an error.
void serve_lines(int input, std::FILE* output, std::size_t line_bytes, Protocol& protocol,
                 const std::atomic<bool>& stop);

}  // namespace unietp
