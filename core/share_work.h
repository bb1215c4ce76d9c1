#pragma once

#include <cstddef>
#include <functional>

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

}  // namespace unietp
