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
  /// Shows the text in place of the last one; ignored within 0.2 s of the last.
  void draw(const std::string& text);
  /// Erases the line, so that other output can be written.
  void wipe();

 private:
  bool terminal_ = false, drawn_ = false;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace unietp
