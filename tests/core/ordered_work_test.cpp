#include "core/ordered_work.h"

#include <atomic>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace unietp {
namespace {

/// What is taken of the numbers below `count` with so many threads; stops with an error at `last`.
std::vector<int> taken(int threads, int count, int last, bool& failed) {
  int next = 0;
  std::vector<int> all;
  const auto done = work_in_order<int, int>(
      threads, [&]() -> std::optional<int> { return next < count ? std::optional(next++) : std::nullopt; },
      [](const int& number) {
        volatile int effort = (7 * number) % 11 * 1000;  // so that items end in another order than they begin
        while (effort > 0) effort = effort - 1;
        return 2 * number;
      },
      [&](int&& made) -> Result<Done> {
        if (made == 2 * last) return Error{Error::Kind::Schema, "here", {}, "last"};
        all.push_back(made);
        return Done{};
      });
  failed = !done;
  return all;
}

TEST(WorkInOrder, TakesEverythingInTheOrderOfTheStream) {
  std::vector<int> expected;
  for (int i = 0; i < 1000; ++i) expected.push_back(2 * i);
  for (const int threads : {1, 2, 7}) {
    bool failed = true;
    EXPECT_EQ(taken(threads, 1000, -1, failed), expected) << threads;
    EXPECT_FALSE(failed);
  }
}

TEST(WorkInOrder, StopsAtTheFirstErrorInThatOrder) {
  for (const int threads : {1, 2, 7}) {
    bool failed = false;
    EXPECT_EQ(taken(threads, 1000, 500, failed).size(), 500U) << threads;
    EXPECT_TRUE(failed);
  }
}

TEST(WorkInOrder, KeepsFewItemsThatWereNotTaken) {
  std::atomic<int> begun{0}, taken{0}, most{0};
  const auto done = work_in_order<int, int>(
      4, [&]() -> std::optional<int> { return begun < 2000 ? std::optional(begun++) : std::nullopt; },
      [&](const int& number) {
        if (most < begun - taken) most = begun - taken;
        return number;
      },
      [&](int&&) -> Result<Done> {
        ++taken;
        return Done{};
      });
  EXPECT_TRUE(done);
  EXPECT_LE(most, 16 * 4);
}

TEST(WorkInOrder, AnExceptionReachesTheCaller) {
  for (const int threads : {1, 3}) {
    int next = 0;
    EXPECT_THROW((void)(work_in_order<int, int>(
                     threads, [&]() -> std::optional<int> { return next++; },
                     [](const int& number) -> int { return number < 50 ? number : throw std::runtime_error("broken"); },
                     [](int&&) -> Result<Done> { return Done{}; })),
                 std::runtime_error);
  }
}

}  // namespace
}  // namespace unietp
