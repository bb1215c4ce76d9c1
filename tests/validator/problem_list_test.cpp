#include "validator/problem_list.h"

#include <gtest/gtest.h>

namespace unietp {
namespace {

Problem of_task(const std::string& task, ProblemKind kind) {
  auto problem = problem_in(kind, "tasks.jsonl", "is wrong");
  problem.task = task;
  return problem;
}

TEST(ProblemList, KeepsTheFirstOfEachKindAndCountsAll) {
  ProblemList list;
  const int many = static_cast<int>(ProblemList::kKept) + 5;
  for (int i = 0; i < many; ++i) list.add(of_task("task-" + std::to_string(i), ProblemKind::View));
  list.add(of_task("other", ProblemKind::Quota));
  EXPECT_EQ(list.count(ProblemKind::View), many);
  EXPECT_EQ(list.count(ProblemKind::Quota), 1);
  EXPECT_EQ(list.count(ProblemKind::Counts), 0);
  EXPECT_EQ(list.kept().size(), ProblemList::kKept + 1);
  EXPECT_TRUE(list.blames("task-" + std::to_string(many - 1)));  // of which no problem is kept
  EXPECT_FALSE(list.blames("nobody"));
}

TEST(ProblemList, TakesAnotherOneWithAllThatItCounted) {
  ProblemList first, second;
  for (std::size_t i = 0; i < ProblemList::kKept; ++i) first.add(of_task("a", ProblemKind::View));
  for (std::size_t i = 0; i < ProblemList::kKept + 7; ++i) second.add(of_task("b", ProblemKind::View));
  first.add(std::move(second));
  EXPECT_EQ(first.count(ProblemKind::View), 2 * ProblemList::kKept + 7);
  EXPECT_EQ(first.kept().size(), ProblemList::kKept);
  EXPECT_TRUE(first.blames("b"));
}

}  // namespace
}  // namespace unietp
