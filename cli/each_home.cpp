#include "cli/each_home.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "cli/progress_line.h"

namespace unietp {
namespace {

std::string progress_text(std::size_t done, std::size_t count, double seconds, const std::string& unit) {
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
  std::atomic<std::size_t> next{0};
  std::mutex mutex;  // guards all below
  std::exception_ptr thrown;
  std::size_t done = 0;
  bool ended = false;

  const auto take = [&] {
    for (std::size_t i = next++; i < count && !interrupted(); i = next++) {
      try {
        const bool go_on = work(i);
        const std::scoped_lock lock(mutex);
        ++done;
        if (!go_on) ended = true, next = count;
        line.draw(
            progress_text(done, count, std::chrono::duration<double>(Clock::now() - start).count(), std::string(unit)));
      } catch (...) {  // a broken invariant: carried to the caller's thread
        const std::scoped_lock lock(mutex);
        thrown = std::current_exception();
        next = count;
      }
    }
  };
  const int helpers = static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(threads), count)) - 1;
  std::vector<std::thread> others;
  others.reserve(static_cast<std::size_t>(std::max(0, helpers)));
  for (int i = 0; i < helpers; ++i) others.emplace_back(take);
  take();
  for (auto& other : others) other.join();
  if (thrown) std::rethrow_exception(thrown);
  return ended || done == count;
}

}  // namespace unietp
