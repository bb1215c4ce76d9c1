// Tasks as episodes of habitat-lab. That its data set class loads them is shown by checks/judges.
#include "exports/habitat_episode.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "exports/express.h"
#include "interchange/habitat_assets.h"

namespace unietp {
namespace {

using ::testing::ElementsAre;
using Json = nlohmann::ordered_json;

Node node(const std::string& id, const std::string& category, bool movable, const Vec3& at) {
  Node made;
  made.id = id, made.category = category, made.movable = movable, made.archetype = Archetype::Box;
  made.size = {0.1, 0.1, 0.1}, made.mass = 0.2, made.pose = upright(at, 0);
  return made;
}

/// Two equal bowls on a table beside a fridge that stands half open; the demonstration puts the second into the fridge.
FinishedTask task() {
  FinishedTask made;
  made.record.id = "habitat-00001";
  made.record.instruction = "Put a bowl in the fridge.";
  Scene& start = made.start;
  start.simulator = Simulator::Habitat;
  start.agent.position = {1, 2};
  start.agent.yaw = std::numbers::pi / 2;
  start.nodes.push_back(node("table_1", "table", false, {0, 0, 0.4}));
  Node fridge = node("fridge_1", "fridge", false, {3, 0, 0.9});
  fridge.archetype = Archetype::Cabinet, fridge.size = {0.8, 0.7, 1.8}, fridge.openable = true, fridge.opening = 0.5;
  start.nodes.push_back(fridge);
  start.nodes.push_back(node("bowl_1", "bowl", true, {0, 0, 0.85}));
  start.nodes.push_back(node("bowl_2", "bowl", true, {0.2, 0, 0.85}));
  for (const auto* bowl : {"bowl_1", "bowl_2"}) start.edges.insert({Predicate::On, bowl, "table_1"});
  StepRecord step;
  step.command.action = "place_in";
  step.command.args = {{"fridge_1", {}}};
  step.success = true;
  Node moved = start.nodes[3];
  moved.pose = upright({3, 0, 0.5}, 0);
  step.changes.nodes = {moved};
  step.changes.edges_removed = {{Predicate::On, "bowl_2", "table_1"}};
  step.changes.edges_added = {{Predicate::Inside, "bowl_2", "fridge_1"}};
  made.shown[Mode::M1].steps = {step};
  return made;
}

TEST(HabitatEpisode, NamesWhatMovesByItsOrderAndWhatStandsByTheScene) {
  const FinishedTask made = task();
  const std::string bowl = habitat_stand_in_name(made.start.nodes[2]);
  const Json episode = habitat_episode(made, {{"table_1", "table_:0000"}, {"fridge_1", "fridge_:0000"}});
  ASSERT_EQ(episode["rigid_objs"].size(), 2U);
  EXPECT_EQ(episode["rigid_objs"][0][0], bowl + ".object_config.json");
  EXPECT_EQ(episode["info"]["unietp"]["names"]["bowl_2"], bowl + "_:0001");
  EXPECT_EQ(episode["info"]["unietp"]["names"]["fridge_1"], "fridge_:0000");
  EXPECT_EQ(episode["info"]["unietp"]["plan"][0]["action"], "place_in");
}

TEST(HabitatEpisode, ATargetIsWhatEndsElsewhere) {
  const FinishedTask made = task();
  const std::string second = habitat_stand_in_name(made.start.nodes[2]) + "_:0001";
  const Json episode = habitat_episode(made, {{"table_1", "table_:0000"}, {"fridge_1", "fridge_:0000"}});
  ASSERT_EQ(episode["targets"].size(), 1U);
  ASSERT_TRUE(episode["targets"].contains(second));
  const Json& rows = episode["targets"][second];  // W's (3, 0, 0.5) is Habitat's (3, 0.5, 0)
  EXPECT_EQ(rows[0][3], 3.0);
  EXPECT_EQ(rows[1][3], 0.5);
  EXPECT_EQ(rows[2][3], 0.0);
  EXPECT_EQ(episode["goal_receptacles"], Json::array({Json::array({"fridge_:0000", nullptr})}));
  EXPECT_EQ(episode["target_receptacles"], Json::array({Json::array({"table_:0000", nullptr})}));
  EXPECT_EQ(episode["info"]["object_labels"][second], "any_targets|0");
}

TEST(HabitatEpisode, TheAgentAndDoorsStandAsAtTheStart) {
  const Json episode = habitat_episode(task(), {{"table_1", "table_:0000"}, {"fridge_1", "fridge_:0000"}});
  EXPECT_EQ(episode["start_position"], Json({1.0, 0.0, -2.0}));
  EXPECT_EQ(episode["start_rotation"], Json({0.0, 0.0, 0.0, 1.0})) << "W's +y is Habitat's -z, the way of no turn";
  const Json& doors = episode["ao_states"]["fridge_:0000"];
  ASSERT_FALSE(doors.empty());
  EXPECT_GT(doors["0"].get<double>(), 0.3);
}

TEST(HabitatEpisode, IsRefusedWhereSomethingOfHabitatsOwnStandsOpen) {
  FinishedTask made = task();
  EXPECT_EQ(refused_by_habitat(made), "") << "our fridge has a stand-in with joints";
  Node& fridge = *edit_node(made.start, "fridge_1");
  fridge.id = "fridge_:0000";
  EXPECT_EQ(refused_by_habitat(made), "fridge_:0000 is open at the start, and the joints of fridge are not known");
  fridge.opening = 0;
  EXPECT_EQ(refused_by_habitat(made), "");
  fridge.opening = 0.5, fridge.openable = false;
  EXPECT_EQ(refused_by_habitat(made), "");
}

}  // namespace
}  // namespace unietp
