#pragma once

#include <chrono>
#include <string>

namespace unietp {

/// Minutes and seconds: "1:05".
std::string clock_text(double seconds);

/// One line on stderr that is drawn over itself a few times a second; nothing when stderr is no terminal. Wiped at the
/// end of its life.
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
