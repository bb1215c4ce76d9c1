#pragma once

#include <cstddef>
#include <functional>

namespace unietp {

/// Calls `task(i)` for each i below `count`, several at a time, and returns when all are done. Each writes to places of
/// its own, so that the number of threads changes nothing.
void share_work(int threads, std::size_t count, const std::function<void(std::size_t)>& task);

}  // namespace unietp
