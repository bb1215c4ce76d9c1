#include "core/share_work.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace unietp {

int processor_count() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

void run_on_threads(int threads, const std::function<void()>& work) {
  std::mutex mutex;
  std::exception_ptr thrown;
  const auto guarded = [&] {
    try {
      work();
    } catch (...) {
      const std::scoped_lock lock(mutex);
      if (!thrown) thrown = std::current_exception();
    }
  };
  std::vector<std::thread> others;
  for (int i = 1; i < threads; ++i) others.emplace_back(guarded);
  guarded();
  for (auto& other : others) other.join();
  if (thrown) std::rethrow_exception(thrown);
}

void share_work(int threads, std::size_t count, const std::function<void(std::size_t)>& task) {
  std::atomic<std::size_t> next{0};
  const int useful = static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(std::max(1, threads)), count));
  run_on_threads(useful, [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        task(i);
      } catch (...) {
        next = count;
        throw;
      }
    }
  });
}

namespace {

// How often a thread looks whether the others have come to an end before it sleeps: some tens of microseconds, about
// what falling asleep and waking up cost.
constexpr int kLooks = 2000;

void rest_between_looks() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

}  // namespace

struct ThreadTeam::Impl {
  /// What one thread begins with: its own tasks, of which others take some when they have none left.
  struct alignas(64) Part {             // on a cache line of its own
    std::atomic<std::size_t> taken{0};  // tasks begun, in order
  };

  explicit Impl(std::size_t threads) : parts(threads) {
    for (std::size_t i = 1; i < threads; ++i) others.emplace_back([this, i] { follow(i); });
  }
  ~Impl() {
    {
      const std::scoped_lock lock(mutex);
      leaving = true;
    }
    begun.notify_all();
    for (auto& other : others) other.join();
  }

  /// Own tasks first, then what is left of the others'.
  void work(std::size_t thread) {
    const std::size_t threads = parts.size();
    try {
      for (std::size_t turn = 0; turn < threads; ++turn) {
        const std::size_t owner = (thread + turn) % threads;
        for (;;) {
          const std::size_t i = owner + parts[owner].taken.fetch_add(1, std::memory_order_relaxed) * threads;
          if (i >= count) break;
          (*task)(i);
        }
      }
    } catch (...) {
      const std::scoped_lock lock(mutex);
      if (!thrown) thrown = std::current_exception();
    }
  }

  void follow(std::size_t thread) {
    for (std::uint64_t seen = 0;;) {
      std::unique_lock lock(mutex);
      begun.wait(lock, [&] { return leaving || round != seen; });
      if (leaving) return;
      seen = round;
      lock.unlock();
      work(thread);
      if (working.fetch_sub(1, std::memory_order_acq_rel) > 1) continue;
      { const std::scoped_lock last(mutex); }  // so that the wake-up cannot come between looking and sleeping
      ended.notify_one();
    }
  }

  void await_others() {
    for (int looks = 0; looks < kLooks; ++looks) {
      if (working.load(std::memory_order_acquire) == 0) return;
      rest_between_looks();
    }
    std::unique_lock lock(mutex);
    ended.wait(lock, [&] { return working.load(std::memory_order_acquire) == 0; });
  }

  std::vector<Part> parts;  // one for each thread
  std::mutex mutex;
  std::condition_variable begun, ended;
  std::uint64_t round = 0;
  std::atomic<std::size_t> working{0};  // other threads that have not ended the round
  bool leaving = false;
  std::size_t count = 0;
  const std::function<void(std::size_t)>* task = nullptr;
  std::exception_ptr thrown;
  std::vector<std::thread> others;
};

ThreadTeam::ThreadTeam(int threads) : impl_(std::make_unique<Impl>(static_cast<std::size_t>(std::max(1, threads)))) {}
ThreadTeam::~ThreadTeam() = default;

void ThreadTeam::share(std::size_t count, const std::function<void(std::size_t)>& task) {
  Impl& team = *impl_;
  {
    const std::scoped_lock lock(team.mutex);
    team.count = count;
    team.task = &task;
    for (auto& part : team.parts) part.taken.store(0, std::memory_order_relaxed);
    team.working.store(team.others.size(), std::memory_order_relaxed);
    ++team.round;
  }
  team.begun.notify_all();
  team.work(0);
  team.await_others();
  if (team.thrown) std::rethrow_exception(std::exchange(team.thrown, nullptr));
}

}  // namespace unietp
