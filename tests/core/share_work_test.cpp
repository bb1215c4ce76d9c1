#include "core/share_work.h"

#include <atomic>
#include <chrono>
#include <set>
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

TEST(ThreadTeam, DoesEveryTaskOfEveryRoundOnce) {
  for (const int threads : {1, 2, 5}) {
    ThreadTeam team(threads);
    for (int round = 0; round < 500; ++round) {
      std::vector<std::atomic<int>> done(7);
      team.share(done.size(), [&](std::size_t i) { ++done[i]; });
      for (const auto& times : done) ASSERT_EQ(times, 1);
    }
    team.share(0, [](std::size_t) { ADD_FAILURE(); });
  }
}

TEST(ThreadTeam, BeginsWithTheSameTasksOnTheSameThreads) {
  constexpr std::size_t kThreads = 3;
  ThreadTeam team(kThreads);
  std::vector<std::thread::id> of_task(kThreads);
  for (int round = 0; round < 50; ++round) {
    std::atomic<std::size_t> there{0};
    team.share(kThreads, [&](std::size_t i) {
      ++there;
      while (there < kThreads) {  // nobody is free to take another's task
      }
      if (round == 0) of_task[i] = std::this_thread::get_id();
      EXPECT_EQ(of_task[i], std::this_thread::get_id());
    });
  }
  EXPECT_EQ(std::set<std::thread::id>(of_task.begin(), of_task.end()).size(), kThreads);
}

TEST(ThreadTeam, TakesWhatIsLeftOfOthersTasks) {
  ThreadTeam team(2);
  // The second task of the first thread can only end when the other thread has done all else.
  std::atomic<int> done{0};
  team.share(8, [&](std::size_t i) {
    if (i == 2) {
      while (done < 7) {
      }
    }
    ++done;
  });
  EXPECT_EQ(done, 8);
}

TEST(ThreadTeam, ThrowsWhatATaskThrewAndGoesOn) {
  ThreadTeam team(3);
  EXPECT_THROW(team.share(9,
                          [](std::size_t i) {
                            if (i == 4) throw std::runtime_error("4");
                          }),
               std::runtime_error);
  std::atomic<int> done{0};
  team.share(9, [&](std::size_t) { ++done; });
  EXPECT_EQ(done, 9);
}

}  // namespace
}  // namespace unietp
