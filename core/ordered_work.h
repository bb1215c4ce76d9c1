#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>

#include "core/result.h"
#include "core/share_work.h"

namespace unietp {

/// Calls `work` on the items of a stream, with so many threads, and `take` with the results in the order of the stream,
/// so that the number of threads changes nothing. At most 16 items per thread are in memory. `next` and `take` are
/// called by one thread at a time; `next` returns nullopt at the end. Stops at the first error of `take` and returns
/// it.
template <class Item, class Made>
Result<Done> work_in_order(int threads, const std::function<std::optional<Item>()>& next,
                           const std::function<Made(const Item&)>& work,
                           const std::function<Result<Done>(Made&&)>& take) {
  const std::size_t most = 16 * static_cast<std::size_t>(threads > 1 ? threads : 1);  // items that were not taken yet
  std::mutex mutex;
  std::condition_variable taken_some;
  std::deque<std::optional<Made>> made;  // of the items begun, in order, from the first that was not taken
  std::size_t taken = 0;                 // items before it
  bool at_end = false;
  Result<Done> result = Done{};
  const auto work_on_items = [&] {
    std::unique_lock lock(mutex);
    try {
      for (;;) {
        taken_some.wait(lock, [&] { return at_end || made.size() < most; });
        if (at_end) return;
        auto item = next();
        if (!item) break;
        const std::size_t place = taken + made.size();
        made.emplace_back();
        lock.unlock();
        auto one = work(*item);
        lock.lock();
        if (at_end && !result) return;
        made[place - taken] = std::move(one);
        while (!made.empty() && made.front() && result) {
          result = take(std::move(*made.front()));
          made.pop_front();
          ++taken;
        }
        if (!result) break;
        taken_some.notify_all();
      }
    } catch (...) {  // a broken invariant; the other threads must not wait for this one
      if (!lock) lock.lock();
      at_end = true;
      taken_some.notify_all();
      throw;
    }
    at_end = true;
    taken_some.notify_all();
  };
  run_on_threads(threads, work_on_items);
  return result;
}

}  // namespace unietp
