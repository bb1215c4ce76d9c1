#include "cli/progress_line.h"

#include <cstdio>

namespace unietp {

std::string clock_text(double seconds) {
  const int whole = static_cast<int>(seconds);
  const auto rest = std::to_string(whole % 60);
  return std::to_string(whole / 60) + ":" + (rest.size() < 2 ? "0" : "") + rest;
}

void ProgressLine::draw(const std::string& text) {
  const auto time = std::chrono::steady_clock::now();
  constexpr std::chrono::milliseconds kPause{200};
  if (!terminal_ || (drawn_ && time - last_ < kPause)) return;
  last_ = time;
  drawn_ = true;
  (void)std::fprintf(stderr, "\r\033[K%s", text.c_str());
}

void ProgressLine::wipe() {
  if (drawn_) (void)std::fprintf(stderr, "\r\033[K");
  drawn_ = false;
}

}  // namespace unietp
