#include "core/share_work.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace unietp {

void share_work(int threads, std::size_t count, const std::function<void(std::size_t)>& task) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr thrown;
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        task(i);
      } catch (...) {  // a broken invariant: carried to the caller's thread
        const std::scoped_lock lock(mutex);
        thrown = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::thread> others;
  for (int i = 1; i < threads; ++i) others.emplace_back(work);
  work();
  for (auto& other : others) other.join();
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace unietp
