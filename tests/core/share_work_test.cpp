#include "core/share_work.h"

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace unietp {
namespace {

TEST(ShareWork, DoesEachTaskOnceForAnyNumberOfThreads) {
  for (const int threads : {0, 1, 2, 7, 100}) {
    SCOPED_TRACE(threads);
    std::vector<std::atomic<int>> done(50);
    share_work(threads, done.size(), [&](std::size_t i) { ++done[i]; });
    for (const auto& times : done) EXPECT_EQ(times, 1);
  }
}

TEST(ShareWork, WithoutTasksCallsNothing) {
  share_work(4, 0, [](std::size_t) { FAIL(); });
}

TEST(ShareWork, ThrowsWhatATaskThrewAndBeginsNoFurtherOnes) {
  constexpr int kTasks = 1000;
  for (const int threads : {1, 4}) {
    SCOPED_TRACE(threads);
    std::atomic<int> begun{0};
    const auto task = [&](std::size_t i) {
      ++begun;
      if (i == 0) throw std::runtime_error("broken");
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    };
    EXPECT_THROW(share_work(threads, kTasks, task), std::runtime_error);
    EXPECT_LT(begun, kTasks);
  }
}

TEST(RunOnThreads, RunsTheWorkOnAsManyThreadsAtOnceAsAsked) {
  constexpr int kThreads = 4;
  std::atomic<int> there{0};
  run_on_threads(kThreads, [&] {
    ++there;
    while (there < kThreads) {  // returns only when all are there together
    }
  });
  EXPECT_EQ(there, kThreads);
}

TEST(RunOnThreads, ThrowsOnlyWhenAllHaveReturned) {
  std::atomic<int> returned{0};
  EXPECT_THROW(run_on_threads(3,
                              [&] {
                                if (returned++ == 0) throw std::runtime_error("broken");
                              }),
               std::runtime_error);
  EXPECT_EQ(returned, 3);
}

TEST(ProcessorCount, IsAtLeastOne) { EXPECT_GE(processor_count(), 1); }

}  // namespace
}  // namespace unietp
