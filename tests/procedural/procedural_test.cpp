// New tasks without end: each is proven, depends only on its seed, and costs little in a home that is there.
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../resources/committed.h"
#include "core/limits.h"
#include "core/share_work.h"
#include "environment/environment.h"
#include "logic/evaluate.h"
#include "procedural/procedural.h"
#include "run/blocks.h"
#include "scene/trace.h"
#include "tests/environment/random_agent.h"

namespace unietp {
namespace {

using ::testing::HasSubstr;

/// The committed resources, which live as long as the program.
std::shared_ptr<const Resources> resources() { return {std::shared_ptr<const Resources>(), &committed()}; }

Procedural procedural(const ProceduralOptions& options) {
  auto made = Procedural::make(resources(), options);
  EXPECT_TRUE(made) << format(made.error());
  return std::move(*made);
}

ProceduralOptions few_homes() {
  ProceduralOptions options;
  options.homes = 2;
  return options;
}

TEST(ProceduralTasks, AreOfTheWantedKindsAndFalseAtTheStart) {
  ProceduralOptions options = few_homes();
  options.simulators = {Simulator::Ai2thor, Simulator::Habitat};
  options.splits = {Split::Atomic, Split::InstanceGrounding};
  const Procedural source = procedural(options);
  std::set<std::string> kinds, instructions;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const auto task = source.task(seed);
    ASSERT_TRUE(task) << format(task.error());
    const EnvironmentTask& one = **task;
    kinds.insert(std::string(name_of(one.simulator)) + " " + one.text.split);
    instructions.insert(one.text.instruction);
    EXPECT_FALSE(holds(one.goal, to_logic(one.start, {}, reads_comparisons(one.goal))));
    EXPECT_EQ(one.text.expert.front().mode, Mode::M1);
    const auto left = Environment::make(*task, settings_for(Mode::M1))->expert_steps_left();
    const auto& shown = one.text.expert.front();  // closes what it opened, too
    EXPECT_EQ(left, shown.shortest == 0 ? shown.steps : shown.shortest) << "the expert solves it from the start";
  }
  EXPECT_EQ(kinds, (std::set<std::string>{"ai2thor atomic", "ai2thor instance_grounding", "habitat atomic",
                                          "habitat instance_grounding"}));
  EXPECT_GT(instructions.size(), 8U);
}

TEST(ProceduralTasks, DependOnTheirSeedAloneWhateverWasMadeBeforeAndByHowManyThreads) {
  const Procedural first = procedural(few_homes()), second = procedural(few_homes());
  constexpr std::uint64_t kSeeds = 8;
  std::vector<Result<SharedTask>> backwards(kSeeds, Error{});
  share_work(3, kSeeds, [&](std::size_t i) { backwards[kSeeds - 1 - i] = second.task(kSeeds - 1 - i); });
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const auto task = first.task(seed);
    const auto& again = backwards[seed];
    ASSERT_TRUE(task && again) << seed;
    EXPECT_EQ((*task)->text.instruction, (*again)->text.instruction);
    EXPECT_EQ((*task)->text.goal_text, (*again)->text.goal_text);
    EXPECT_TRUE((*task)->start == (*again)->start);
  }
}

TEST(ProceduralTasks, CanBeSolvedInTheModesThatWereAskedFor) {
  ProceduralOptions options = few_homes();
  options.simulators = {Simulator::Ai2thor};
  options.splits = {Split::Atomic};
  options.modes = {Mode::M3};
  const Procedural source = procedural(options);
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const auto task = source.task(seed);
    ASSERT_TRUE(task) << format(task.error());
    ASSERT_EQ((*task)->text.expert.size(), 2U);
    EXPECT_EQ((*task)->text.expert.back().mode, Mode::M3);
  }
}

TEST(ProceduralTasks, AreInHomesThatNoDataSetHas) {
  // Homes of the training pool are known by their seed and number. Those of a run are numbered from 0 on, and are at
  // most as many as its tasks; the most that a run may have is kTasks.
  std::vector<TaskSlot> slots(100);
  for (std::size_t i = 0; i < slots.size(); ++i) slots[i].simulator = kSimulators[i % kSimulators.size()];
  for (const int block : {1, 7, 100}) {
    RunConfiguration run;
    run.homes = HomeSource::Training;
    run.block = block;
    for (const Block& one : blocks_of(run, committed(), slots)) {
      for (const HomeRange& homes : one.homes) EXPECT_LE(homes.first + homes.count, 100);
    }
  }
  const Procedural source = procedural({});
  std::set<std::string> homes;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const auto task = source.task(seed);
    ASSERT_TRUE(task) << format(task.error());
    const std::string& home = (*task)->text.layout;
    homes.insert(home);
    EXPECT_GE(std::stoll(home.substr(home.rfind('-') + 1)), std::int64_t{limits::kTasks}) << home;
  }
  EXPECT_GT(homes.size(), 12U);
}

TEST(ProceduralTasks, RefuseWhatCannotBe) {
  ProceduralOptions options;
  options.templates = {"no-such-template"};
  const auto unknown = Procedural::make(resources(), options);
  ASSERT_FALSE(unknown);
  EXPECT_THAT(format(unknown.error()), HasSubstr("no-such-template"));
  options = {};
  options.homes = 0;
  EXPECT_FALSE(Procedural::make(resources(), options));
  EXPECT_FALSE(procedural(few_homes()).task(~std::uint64_t{0}));
}

}  // namespace
}  // namespace unietp
