// What OmniGibson refuses by BEHAVIOR's annotations.
#include "exports/behavior_abilities.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "tests/support/scratch_folder.h"

namespace unietp {
namespace {

using ::testing::HasSubstr;

Node thing(const std::string& id, const std::string& category, const std::vector<State>& states = {}) {
  Node node;
  node.id = id, node.category = category, node.size = Vec3::Ones();
  for (const State& state : states) node.states.set(state);
  return node;
}

/// By the committed tables.
std::string refused_by_omnigibson(FinishedTask task, const LtlfGoal& goal = {}) {
  static const auto synsets = read_bddl_synsets(UNIETP_SOURCE_DIR "/data/bddl/synsets.csv");
  static const auto abilities = read_behavior_abilities(UNIETP_SOURCE_DIR "/data/bddl/abilities.csv");
  (void)task.shown[Mode::M1];
  return denied_by_omnigibson(task, goal, *synsets, *abilities);
}

FinishedTask in_omnigibson(std::vector<Node> nodes, const std::vector<std::pair<std::string, std::string>>& steps,
                           const std::string& held = "") {
  FinishedTask task;
  task.start.simulator = Simulator::Behavior;
  for (Node& node : nodes) task.start.nodes.push_back(std::move(node));
  for (const auto& [action, argument] : steps) {
    StepRecord step;
    step.command = {action, {{argument, {}}}};
    step.success = true;
    task.shown[Mode::M1].steps.push_back(step);
  }
  if (!held.empty()) task.start.agent.held = {held};
  return task;
}

TEST(Omnigibson, OpensOnlyWhatBehaviorCallsOpenable) {
  const std::vector<Node> nodes{thing("wardrobe_1", "wardrobe"), thing("fridge_1", "fridge"),
                                thing("nightstand_1", "nightstand")};
  EXPECT_EQ(refused_by_omnigibson(in_omnigibson(nodes, {{"open", "fridge_1"}})), "");
  EXPECT_EQ(refused_by_omnigibson(in_omnigibson(nodes, {{"open", "wardrobe_1"}})),
            "OmniGibson refuses open with wardrobe, which is not `openable` in BEHAVIOR");
  EXPECT_THAT(refused_by_omnigibson(in_omnigibson(nodes, {{"open", "nightstand_1"}})), HasSubstr("not `openable`"))
      << "the table has nothing of its synset";
}

TEST(Omnigibson, HasStatesOnlyOfWhatHasTheAbility) {
  const auto task = in_omnigibson({thing("wardrobe_1", "wardrobe"), thing("fridge_1", "fridge")}, {});
  LtlfGoal goal;
  goal.propositions.push_back({"closed_it", "closed", {"fridge_1"}, false, Predicate::Closed, {}});
  EXPECT_EQ(refused_by_omnigibson(task, goal), "");
  goal.propositions[0].arguments = {"wardrobe_1"};
  EXPECT_EQ(refused_by_omnigibson(task, goal),
            "OmniGibson has no `closed` of wardrobe, which is not `openable` in BEHAVIOR");
}

TEST(Omnigibson, WipesStainsWithWhatNeedsNoDetergentAndSoaksWhatTakesWater) {
  const State dirty{Predicate::Dirty, ""}, clean{Predicate::Clean, ""};
  const auto doing = [&](const std::string& action, const std::string& tool, const State& state) {
    return refused_by_omnigibson(
        in_omnigibson({thing("desk_1", action == "wipe" ? "desk" : "furniture_sink", {state}), thing("tool_1", tool)},
                      {{action, "desk_1"}}, "tool_1"));
  };
  EXPECT_EQ(doing("wipe", "steel_wool", dirty), "");
  EXPECT_THAT(doing("wipe", "sponge", dirty), HasSubstr("wipe with sponge, which is not `wipes_stains`"));
  EXPECT_EQ(doing("wipe", "sponge", clean), "") << "what else covers it";
  EXPECT_EQ(doing("soak_with", "sponge", clean), "");
  EXPECT_THAT(doing("soak_with", "steel_wool", clean), HasSubstr("soak_with with steel_wool"));
}

/// A microwave's 100 °C and the room's 23 °C are in balance at 87 °C, and a potato cooks at 98 °C.
TEST(Omnigibson, CooksOnlyWhatASourceGetsHotEnough) {
  const State raw{Predicate::Raw, ""}, cooked{Predicate::Cooked, ""};
  const auto cooking = [&](const std::string& device, const std::string& food) {
    auto task =
        in_omnigibson({thing("device_1", device), thing("food_1", food, {raw})}, {{"cook_with", "device_1"}}, "food_1");
    task.shown[Mode::M1].steps[0].changes.nodes = {thing("food_1", food, {cooked})};
    return refused_by_omnigibson(task);
  };
  EXPECT_EQ(cooking("oven", "potato"), "");
  EXPECT_EQ(cooking("microwave", "potato"),
            "potato does not become cooked with microwave in OmniGibson: at 98 °C, and it gets to 87 °C");
  EXPECT_EQ(cooking("microwave", "apple"), "") << "at 58 °C";
  EXPECT_THAT(cooking("desk", "apple"), HasSubstr("cook_with with desk, which is not `heat_source`"));
}

TEST(Omnigibson, ATableThatIsNoneIsRefused) {
  const ScratchFolder folder;
  const auto error_of = [&](const std::string& text) {
    EXPECT_TRUE(write_file(folder.at(""), "abilities.csv", text));
    const auto read = read_behavior_abilities(folder.at("abilities.csv"));
    return read ? std::string() : format(read.error());
  };
  const std::string header = "synset,ability,celsius,rate_per_s,source\n";
  EXPECT_EQ(error_of(header + "oven.n.01,heat_source,250,0.1,x\n"), "");
  EXPECT_THAT(error_of(header + "oven.n.01,heat_source,hot,0.1,x\n"), HasSubstr("2:23"));
  EXPECT_THAT(error_of(header + "oven.n.01,openable,,,x\noven.n.01,openable,,,x\n"), HasSubstr("stands twice"));
  EXPECT_THAT(error_of("synset,ability\n"), HasSubstr("celsius"));
}

}  // namespace
}  // namespace unietp
