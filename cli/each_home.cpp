#include "cli/each_home.h"

#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <mutex>

#include "cli/progress_line.h"
#include "core/share_work.h"

namespace unietp {
namespace {

std::string homes_progress(std::size_t done, std::size_t count, double seconds, const std::string& unit) {
  const double rate = seconds > 0 ? static_cast<double>(done) / seconds : 0;
  const auto left = rate > 0 ? clock_text(static_cast<double>(count - done) / rate) : std::string("-:--");
  std::array<char, 96> text{};
  (void)std::snprintf(text.data(), text.size(), "%zu of %zu %s  %.2f %s/s  %s left", done, count, unit.c_str(), rate,
                      unit.c_str(), left.c_str());
  return text.data();
}

}  // namespace

bool for_each_home(std::size_t count, int threads, const CommandLine& program,
                   const std::function<bool(std::size_t)>& work, std::string_view unit) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  ProgressLine line(program.terminal && count > 1);
  const auto interrupted = [&] { return program.interrupted != nullptr && program.interrupted->load(); };
  std::atomic<bool> ended{false};
  std::mutex mutex;  // guards all below
  std::size_t done = 0;

  share_work(threads, count, [&](std::size_t i) {
    if (ended || interrupted()) return;
    if (!work(i)) ended = true;
    const std::scoped_lock lock(mutex);
    ++done;
    line.draw(
        homes_progress(done, count, std::chrono::duration<double>(Clock::now() - start).count(), std::string(unit)));
  });
  return ended || done == count;
}

}  // namespace unietp
