#pragma once

#include <chrono>
#include <string>

namespace unietp {

/// Minutes and seconds: "1:05".
std::string clock_text(double seconds);

/// A progress line on stderr, redrawn at most five times a second; does nothing when stderr is not a terminal. The
/// destructor erases it.
class ProgressLine {
 public:
  explicit ProgressLine(bool terminal) : terminal_(terminal) {}
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine() { wipe(); }
  void draw(const std::string& text);
  void wipe();

 private:
  bool terminal_ = false, drawn_ = false;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace unietp
