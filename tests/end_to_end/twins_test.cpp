// The demonstrations of M2 and M3 in a data set follow from what the mode told and showed: the expert does the same
// again behind a record of that, with no world, and in a world that lacks what it uses and sees last of all it does the
// same until that shows. On the folder in UNIETP_DATASET where it is set.
#include <map>

#include <gtest/gtest.h>

#include "expert/belief_expert.h"
#include "expert/witness.h"
#include "grounding/household.h"
#include "task_sources.h"

namespace unietp {
namespace {

const Household& household(const Knowledge& knowledge) {
  static std::map<Simulator, Household> all;
  const auto known = all.find(knowledge.simulator());
  if (known != all.end()) return known->second;
  auto read = read_household(std::filesystem::path(UNIETP_SOURCE_DIR) / "data" / "sense", knowledge);
  EXPECT_TRUE(read) << format(read.error());
  return all.emplace(knowledge.simulator(), std::move(*read)).first->second;
}

SearchProblem problem_of(const EnvironmentTask& task, Mode mode) {
  return {task.goal, *task.data.knowledge, *task.data.profile, &household(*task.data.knowledge), mode};
}

struct Played {
  Witnessed seen;
  std::vector<Action> done;  // on the ids of the home
};

/// What the expert of a mode is shown and does in a start.
Played played(const EnvironmentTask& task, Mode mode, const Scene& start) {
  auto executions = ExecutionTree::of(task.goal, start, *task.data.knowledge, *task.data.profile);
  EXPECT_TRUE(executions) << format(executions.error());
  EpisodeWindow window(*executions, mode);
  WitnessWindow witness(window);
  (void)reach_by_belief(problem_of(task, mode), witness);
  return {witness.seen(), window.done()};
}

/// The object whose box it is.
std::string id_of(const Argument& argument, const std::vector<VisibleObject>& visible) {
  if (!argument.box) return argument.id;
  for (const VisibleObject& object : visible) {
    if (object.box == *argument.box) return object.id;
  }
  ADD_FAILURE() << "a box of nothing that is visible";
  return "";
}

Demonstration demonstration_of(const TaskSource& tasks, std::size_t position, Mode mode) {
  const auto stored = tasks.demonstration(position, mode);
  EXPECT_TRUE(stored) << format(stored.error());
  Demonstration demonstration{mode, {}, {}};
  for (const auto& step : stored->steps) {
    Action action{*action_named(step.command.action), {}};
    for (const Argument& argument : step.command.args) action.args.push_back(id_of(argument, step.visible));
    demonstration.steps.push_back({step.visible, std::move(action), step.command, {}, {}});
  }
  return demonstration;
}

void follow_from_what_was_told_and_shown(Mode mode) {
  const TaskSource tasks = source();
  std::size_t shown = 0, twins = 0, distinguishable = 0;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    SCOPED_TRACE(tasks.listing()[i].id);
    const auto task = tasks.task(i);
    ASSERT_TRUE(task) << format(task.error());
    const Demonstration demonstration = demonstration_of(tasks, i, mode);
    const auto [seen, done] = played(**task, mode, (*task)->start);
    std::vector<Action> actions;
    for (const DemonstrationStep& step : demonstration.steps) actions.push_back(step.action);
    ASSERT_EQ(done, actions);
    ASSERT_EQ(seen.actions.size(), actions.size());
    RecordedWindow record(seen);
    EXPECT_FALSE(reach_by_belief(problem_of(**task, mode), record));
    EXPECT_TRUE(record.same());
    ++shown;
    const auto twin = twin_of((*task)->start, demonstration);
    if (!twin) continue;  // everything that it uses was in view at the start
    const Witnessed other = played(**task, mode, *twin).seen;
    EXPECT_TRUE(acted_alike(seen, other));
    ++twins;
    if (same_moments(seen, other) < seen.moments.size()) ++distinguishable;
  }
  std::printf("%zu demonstrations, %zu twins, %zu of them told apart in the end\n", shown, twins, distinguishable);
  EXPECT_GT(twins, 0U);
  EXPECT_EQ(distinguishable, twins) << "a twin lacks something that is used";
}

TEST(DemonstrationsOfM2, FollowFromWhatWasToldAndShown) { follow_from_what_was_told_and_shown(Mode::M2); }

TEST(DemonstrationsOfM3, FollowFromWhatWasToldAndShown) { follow_from_what_was_told_and_shown(Mode::M3); }

}  // namespace
}  // namespace unietp
