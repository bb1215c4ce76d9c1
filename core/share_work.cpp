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

struct ThreadTeam::Impl {
  explicit Impl(std::size_t threads) : threads(threads) {
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

  void do_part(std::size_t thread) {
    try {
      for (std::size_t i = thread; i < count; i += threads) (*task)(i);
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
      do_part(thread);
      lock.lock();
      if (--working == 0) ended.notify_one();
    }
  }

  std::size_t threads = 1;
  std::mutex mutex;
  std::condition_variable begun, ended;
  std::uint64_t round = 0;
  std::size_t working = 0;
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
    team.working = team.others.size();
    ++team.round;
  }
  team.begun.notify_all();
  team.do_part(0);
  std::unique_lock lock(team.mutex);
  team.ended.wait(lock, [&] { return team.working == 0; });
  if (team.thrown) std::rethrow_exception(std::exchange(team.thrown, nullptr));
}

}  // namespace unietp
