#include "serve/line_server.h"

#include <limits>

#include "serve/line_input.h"

namespace unietp {

void serve_lines(int input, std::FILE* output, std::size_t line_bytes, Protocol& protocol,
                 const std::atomic<bool>& stop) {
  LineInput lines(input, line_bytes);
  Caller caller{std::numeric_limits<std::size_t>::max()};  // as many as the protocol has
  while (!stop) {
    const auto got = lines.next(std::chrono::milliseconds(500));
    if (got == LineInput::Got::End) break;
    const auto now = std::chrono::steady_clock::now();
    protocol.reap(now);
    if (got == LineInput::Got::Nothing) continue;
    const bool is_line = got == LineInput::Got::Line;
    const std::string answer = (is_line ? protocol.message(lines.line(), caller, now) : Protocol::too_long()) + "\n";
    if (std::fputs(answer.c_str(), output) < 0 || std::fflush(output) != 0) break;
  }
  protocol.leave(caller);
}

}  // namespace unietp
