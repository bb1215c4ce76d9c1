#include "serve/line_input.h"

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace unietp {

/// The next of the lines that have come.
LineInput::Got LineInput::take() {
  const auto end = unread_.find('\n', searched_);
  const bool is_whole = end != std::string::npos;
  if (!is_whole && unread_.size() > most_bytes_) {
    skipping_ = true;
    unread_.clear();
  }
  searched_ = is_whole ? 0 : unread_.size();
  if (!is_whole && !ended_) return Got::Nothing;
  if (!is_whole && unread_.empty() && !skipping_) return Got::End;
  line_ = unread_.substr(0, end);
  unread_.erase(0, is_whole ? end + 1 : end);
  searched_ = 0;
  return std::exchange(skipping_, false) || line_.size() > most_bytes_ ? Got::TooLong : Got::Line;
}

/// Reads what there is. False when nothing came until then.
bool LineInput::fill(std::chrono::steady_clock::time_point until) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - std::chrono::steady_clock::now()).count();
  pollfd ready{descriptor_, POLLIN, 0};
  if (::poll(&ready, 1, left < 0 ? 0 : static_cast<int>(left)) <= 0) return false;
  char bytes[1 << 16];
  const auto count = ::read(descriptor_, bytes, sizeof bytes);
  if (count < 0 && (errno == EINTR || errno == EAGAIN)) return false;
  if (count <= 0) ended_ = true;
  if (count > 0) unread_.append(bytes, static_cast<std::size_t>(count));
  return true;
}

LineInput::Got LineInput::next(std::chrono::milliseconds at_most) {
  const auto until = std::chrono::steady_clock::now() + at_most;
  for (Got got = take();; got = take()) {
    if (got != Got::Nothing || !fill(until)) return got;
  }
}

}  // namespace unietp
