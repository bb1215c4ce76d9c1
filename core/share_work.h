#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace unietp {

// The one place that starts threads. Work that is shared gives equal results for any number of them.

/// How many the machine runs at once, at least 1.
int processor_count();

/// Runs `work` on this thread and on `threads - 1` others at once; returns when all have returned. What one of them
/// throws (a broken invariant) is thrown here once all have returned: `work` sees to it that the others end.
void run_on_threads(int threads, const std::function<void()>& work);

/// Calls `task(i)` for each i below `count`, several at a time, and returns when all are done. Each writes to places of
/// its own, so that the number of threads changes nothing. After an exception, which is thrown here, no task is begun.
void share_work(int threads, std::size_t count, const std::function<void(std::size_t)>& task);

/// Threads that stay between rounds of work, for rounds so short that starting threads would cost as much. The calling
/// thread is the first of them. One thread at a time may call `share`.
class ThreadTeam {
 public:
  /// `threads`: at least 1.
  explicit ThreadTeam(int threads);
  ~ThreadTeam();

  /// Calls `task(i)` for each i below `count` and returns when all are done. Each thread begins with the same tasks in
  /// every round, near the memory that they used before, and then takes what is left of the others'. What a task
  /// throws is thrown here once all threads have come to an end.
  void share(std::size_t count, const std::function<void(std::size_t)>& task);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace unietp
