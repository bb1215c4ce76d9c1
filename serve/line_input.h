#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace unietp {

/// Lines from a descriptor, such as standard input, of bounded length.
class LineInput {
 public:
  enum class Got {
    Line,     // `line()` is the next one, without its line feed
    TooLong,  // the next one was longer than the limit and was skipped
    Nothing,  // none has come in the time, or a signal came
    End       // there are no more
  };

  /// The descriptor stays the caller's, and must be open as long as this lives.
  LineInput(int descriptor, std::size_t most_bytes) : descriptor_(descriptor), most_bytes_(most_bytes) {}

  /// Waits at most so long for the next line. The last line needs no line feed.
  Got next(std::chrono::milliseconds at_most);
  const std::string& line() const { return line_; }

 private:
  Got take();
  bool fill(std::chrono::steady_clock::time_point until);

  int descriptor_;
  std::size_t most_bytes_, searched_ = 0;  // of `unread_`, in which there is no line feed
  std::string unread_, line_;
  bool skipping_ = false;  // the rest of a line that is too long
  bool ended_ = false;     // the input; `unread_` may still have lines
};

}  // namespace unietp
