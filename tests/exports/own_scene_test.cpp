// What tasks in a simulator's own scenes may ask of it.
#include "exports/own_scene.h"

#include <gtest/gtest.h>

#include "exports/express.h"
#include "tests/support/committed_knowledge.h"

namespace unietp {
namespace {

Node own_thing(const std::string& id, const std::string& category) {
  Node node;
  node.id = id, node.category = category, node.size = Vec3::Ones();
  return node;
}

FinishedTask task_of(Simulator simulator, std::vector<Node> nodes, const std::string& goal,
                     const std::vector<std::pair<std::string, std::string>>& steps) {
  FinishedTask task;
  task.start.simulator = simulator;
  for (Node& node : nodes) task.start.nodes.push_back(std::move(node));
  task.record.goal_tree = *parse_formula("goal", goal, FormulaUse::Goal);
  for (const auto& [action, argument] : steps) {
    StepRecord step;
    step.command = {action, {{argument, {}}}};
    step.success = true;
    task.shown[Mode::M1].steps.push_back(step);
  }
  return task;
}

constexpr const char* kNextTo = "(exists (?a - mug) (exists (?b - plate) (at-end (next_to ?a ?b))))";
constexpr const char* kOn = "(exists (?a - mug) (exists (?b - plate) (at-end (on ?a ?b))))";

TEST(OwnScene, VirtualhomesGraphTellsNothingOfWhatIsNextToWhat) {
  const auto in_apartment = [](const std::string& goal) {
    return task_of(Simulator::Virtualhome, {own_thing("mug.12", "mug"), own_thing("plate_1", "plate")}, goal, {});
  };
  auto asked = in_apartment(kNextTo);
  asked.shown[Mode::M1];
  EXPECT_EQ(beyond_own_simulator(asked), "VirtualHome's graph does not tell next_to");
  auto told = in_apartment(kOn);
  told.shown[Mode::M1];
  EXPECT_EQ(beyond_own_simulator(told), "");
  edit_node(asked.start, "mug.12")->id = "mug_2";
  EXPECT_EQ(beyond_own_simulator(asked), "") << "in a home of ours";
}

TEST(OwnScene, OmnigibsonHasNoPrimitiveForSpreading) {
  const auto with = [](const std::string& action, const std::string& mug) {
    Node node = own_thing(mug, "mug");
    node.asset = "mug-ppzttc";
    return task_of(Simulator::Behavior, {node}, kOn, {{action, mug}});
  };
  for (const std::string action : {"spread_to", "pour_to", "wash_with", "fill_with", "fold", "unfold"})
    EXPECT_EQ(beyond_own_simulator(with(action, "mug_ppzttc_0")), "OmniGibson has no primitive for " + action);
  EXPECT_EQ(beyond_own_simulator(with("wipe", "mug_ppzttc_0")), "");
  EXPECT_EQ(beyond_own_simulator(with("spread_to", "mug_1")), "") << "in a home of ours";
}

TEST(OwnScene, HabitatOpensAndTellsOfPlacesOnly) {
  const std::string own = "fridge_:0000";
  const auto with = [&](const std::string& goal, const std::string& action) {
    return task_of(Simulator::Habitat, {own_thing(own, "fridge")}, goal, {{"go_to", own}, {action, own}});
  };
  EXPECT_EQ(beyond_own_simulator(with(kOn, "open")), "");
  EXPECT_EQ(beyond_own_simulator(with(kOn, "turn_on")), "Habitat has no turn_on");
  EXPECT_EQ(beyond_own_simulator(with(kNextTo, "open")), "Habitat does not tell next_to");
  EXPECT_EQ(refused_by_habitat(with(kNextTo, "open")), "Habitat does not tell next_to") << "so the form refuses it";
}

TEST(OwnScene, AStartPutsThingsOnlyWhereAi2thorsTablesHaveThem) {
  auto task = task_of(
      Simulator::Ai2thor,
      {own_thing("Vase|1|1", "Vase"), own_thing("Sink|1|2", "Sink"), own_thing("DiningTable|1|3", "DiningTable"),
       own_thing("Mug|1|4", "Mug"), own_thing("ShelvingUnit|1|5", "ShelvingUnit")},
      kOn, {});
  const Knowledge& knowledge = committed_knowledge(Simulator::Ai2thor);
  const auto said = [&](const Edge& edge) {
    task.record.changes.edges_added = {edge};
    return unlisted_in_ai2thor(task, knowledge);
  };
  EXPECT_EQ(said({Predicate::Inside, "Vase|1|1", "Sink|1|2"}), "no table of AI2-THOR's has Vase on or in Sink");
  EXPECT_EQ(said({Predicate::Inside, "Mug|1|4", "Sink|1|2"}), "") << "in its basin";
  EXPECT_EQ(said({Predicate::On, "Mug|1|4", "DiningTable|1|3"}), "");
  EXPECT_EQ(said({Predicate::NextTo, "Vase|1|1", "Sink|1|2"}), "");
  EXPECT_EQ(said({Predicate::On, "Mug|1|4", "ShelvingUnit|1|5"}), "") << "on its shelf";
  for (const std::string id : {"Vase|1|1", "Sink|1|2", "DiningTable|1|3", "Mug|1|4", "ShelvingUnit|1|5"})
    edit_node(task.start, id)->id = id.substr(0, id.find('|')) + "_1";
  EXPECT_EQ(said({Predicate::Inside, "Vase_1", "Sink_1"}), "") << "in a home of ours";
}

}  // namespace
}  // namespace unietp
