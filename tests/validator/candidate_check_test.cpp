#include "validator/candidate_check.h"

#include <gtest/gtest.h>

namespace unietp {
namespace {

TaskRecord task_in(int slot, int attempt) {
  TaskRecord task;
  task.simulator = "habitat";
  task.split = "atomic";
  task.id = task.scene = task_id_of(task.simulator, slot);
  task.slot = slot;
  task.attempt = attempt;
  return task;
}

RejectionRecord rejected_in(int slot, int attempt, const char* stage = "expert") {
  return {slot, attempt, "open-one", "habitat", "atomic", stage, "no-plan", ""};
}

/// The problems of tasks and rejections of a run of two tasks with three attempts each.
std::size_t problems_of(const std::vector<TaskRecord>& tasks, const std::vector<RejectionRecord>& rejections) {
  ManifestRecord manifest;
  manifest.run.count = 2;
  manifest.run.attempts = 3;
  CandidateCheck check(manifest);
  for (const auto& task : tasks) check.add(task, task.id, "tasks.jsonl");
  for (const auto& rejection : rejections) check.add(rejection, "rejections.jsonl");
  return check.finish().kept().size();
}

TEST(Candidates, OfASlotAreCountedFromZeroAndAllButTheLastAreRejected) {
  EXPECT_EQ(problems_of({task_in(0, 1), task_in(1, 0)}, {rejected_in(0, 0)}), 0U);
  EXPECT_GT(problems_of({task_in(0, 1), task_in(1, 0)}, {}), 0U);
  EXPECT_GT(problems_of({task_in(0, 1), task_in(1, 0)}, {rejected_in(0, 1)}), 0U);
  EXPECT_GT(problems_of({task_in(0, 1), task_in(1, 0)}, {rejected_in(0, 0), rejected_in(0, 1)}), 0U);
  EXPECT_GT(problems_of({task_in(0, 0), task_in(1, 3)}, {rejected_in(1, 0), rejected_in(1, 1), rejected_in(1, 2)}), 0U);
}

TEST(Candidates, OfASlotThatWasNotFilledAreAllAttempts) {
  EXPECT_EQ(problems_of({task_in(0, 0)}, {rejected_in(1, 0), rejected_in(1, 1), rejected_in(1, 2)}), 0U);
  EXPECT_GT(problems_of({task_in(0, 0)}, {rejected_in(1, 0), rejected_in(1, 1)}), 0U);
}

TEST(Candidates, MayBeTakenOutInAReview) {
  EXPECT_EQ(problems_of({task_in(1, 0)}, {rejected_in(0, 0), rejected_in(0, 1, "review")}), 0U);
  EXPECT_GT(problems_of({task_in(1, 0)}, {rejected_in(0, 1, "review"), rejected_in(0, 0)}), 0U);
}

TEST(Candidates, HaveTheIdAndTheOrderOfTheirSlots) {
  EXPECT_GT(problems_of({task_in(1, 0), task_in(0, 0)}, {}), 0U);
  auto other = task_in(1, 0);
  other.id = "habitat-00009";
  EXPECT_GT(problems_of({task_in(0, 0), other}, {}), 0U);
  auto split = rejected_in(0, 0);
  split.split = "logical";
  EXPECT_GT(problems_of({task_in(0, 1), task_in(1, 0)}, {split}), 0U);
  EXPECT_GT(problems_of({task_in(0, 0), task_in(1, 0), task_in(2, 0)}, {}), 0U);
}

}  // namespace
}  // namespace unietp
