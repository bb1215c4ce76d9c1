// Demonstrations as programs of VirtualHome. That its own simulator executes them is shown by checks/judges.
#include "exports/virtualhome_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

StepRecord step(const std::string& action, const std::vector<std::string>& objects, bool success = true) {
  StepRecord record;
  record.command.action = action;
  for (const auto& object : objects) record.command.args.push_back({object, {}});
  record.success = success;
  return record;
}

/// The same; afterward the hand holds `held`.
StepRecord holding(StepRecord record, const std::vector<std::string>& held) {
  record.changes.agent = Agent{};
  record.changes.agent->held = held;
  return record;
}

Result<std::vector<std::string>> program(const std::vector<StepRecord>& steps) {
  Scene start;
  Node radio;
  radio.id = "radio_2";
  radio.category = "radio";
  radio.states.set({Predicate::PowerOff, {}});
  radio.states.set({Predicate::Unplugged, {}});
  start.nodes.push_back(radio);
  DemonstrationRecord demonstration;
  demonstration.steps = steps;
  return virtualhome_program(
      demonstration, start,
      {{"mug_1", "mug_12"}, {"radio_2", "radio_30"}, {"coffee_table_3", "coffee_table_31"}, {"fridge_4", "fridge_9"}});
}

TEST(VirtualhomeProgram, NamesWhatTheHandHoldsWhereItIsPutDown) {
  const auto lines =
      program({step("go_to", {"mug_1"}), holding(step("pick_up", {"mug_1"}), {"mug_1"}),
               step("go_to", {"coffee_table_3"}), holding(step("place_on", {"coffee_table_3"}), {}), step("stop", {})});
  ASSERT_TRUE(lines) << format(lines.error());
  EXPECT_THAT(*lines, ElementsAre("[Walk] <mug> (12)", "[Grab] <mug> (12)", "[Walk] <coffee_table> (31)",
                                  "[PutBack] <mug> (12) <coffee_table> (31)"));
}

TEST(VirtualhomeProgram, WalksToWhatIsInReachAndPutsItsPlugInOnce) {
  const auto lines = program({step("go_to", {"coffee_table_3"}), step("turn_on", {"radio_2"}),
                              step("turn_off", {"radio_2"}), step("turn_on", {"radio_2"})});
  ASSERT_TRUE(lines) << format(lines.error());
  EXPECT_THAT(*lines, ElementsAre("[Walk] <coffee_table> (31)", "[Walk] <radio> (30)", "[PlugIn] <radio> (30)",
                                  "[SwitchOn] <radio> (30)", "[SwitchOff] <radio> (30)", "[SwitchOn] <radio> (30)"));
}

Node thing(const std::string& id, Predicate state) {
  Node node;
  node.id = id;
  node.states.set({state, {}});
  return node;
}

TEST(VirtualhomeProgram, PutsWhatAThingHeldThereAgainAfterTheGrab) {
  Scene start;
  start.nodes = {thing("tray_1", Predicate::Clean), thing("mug_2", Predicate::Clean), thing("tea_3", Predicate::Clean)};
  start.edges = {{Predicate::Inside, "tea_3", "mug_2"}, {Predicate::On, "mug_2", "tray_1"}};
  DemonstrationRecord demonstration;
  demonstration.steps = {step("go_to", {"tray_1"}), holding(step("pick_up", {"tray_1"}), {"tray_1"}),
                         step("go_to", {"table_4"}), holding(step("place_on", {"table_4"}), {})};
  const auto lines = virtualhome_program(
      demonstration, start, {{"tray_1", "tray_1"}, {"mug_2", "mug_2"}, {"tea_3", "tea_3"}, {"table_4", "table_4"}});
  ASSERT_TRUE(lines) << format(lines.error());
  EXPECT_THAT(*lines,
              ElementsAre("[Walk] <tray> (1)", "[Grab] <tray> (1)", "[Walk] <mug> (2)", "[Grab] <mug> (2)",
                          "[PutBack] <mug> (2) <tray> (1)", "[Walk] <tea> (3)", "[Grab] <tea> (3)", "[Walk] <mug> (2)",
                          "[PutIn] <tea> (3) <mug> (2)", "[Walk] <table> (4)", "[PutBack] <tray> (1) <table> (4)"));
}

TEST(VirtualhomeProgram, PutsWhatIsInsideThereOnceMoreAfterTheWalkAndOpensWhatIsShut) {
  Scene start;
  start.nodes = {thing("box_1", Predicate::Closed), thing("plate_2", Predicate::Clean),
                 thing("pie_3", Predicate::Clean)};
  start.edges = {{Predicate::Inside, "pie_3", "box_1"},
                 {Predicate::Inside, "plate_2", "box_1"},
                 {Predicate::On, "pie_3", "plate_2"}};
  DemonstrationRecord demonstration;
  demonstration.steps = {holding(step("pick_up", {"box_1"}), {"box_1"}), step("go_to", {"table_4"}),
                         holding(step("place_on", {"table_4"}), {})};
  const auto lines = virtualhome_program(
      demonstration, start, {{"box_1", "box_1"}, {"plate_2", "plate_2"}, {"pie_3", "pie_3"}, {"table_4", "table_4"}});
  ASSERT_TRUE(lines) << format(lines.error());
  const std::vector<std::string> pie{"[Walk] <pie> (3)", "[Grab] <pie> (3)", "[Walk] <plate> (2)",
                                     "[PutBack] <pie> (3) <plate> (2)", "[Close] <box> (1)"};
  std::vector<std::string> expected{"[Walk] <box> (1)",   "[Grab] <box> (1)",   "[Open] <box> (1)",
                                    "[Walk] <plate> (2)", "[Grab] <plate> (2)", "[PutIn] <plate> (2) <box> (1)"};
  expected.insert(expected.end(), pie.begin(), pie.end());
  for (const char* one :
       {"[Walk] <table> (4)", "[PutBack] <box> (1) <table> (4)", "[Open] <box> (1)", "[Walk] <plate> (2)",
        "[Grab] <plate> (2)", "[Walk] <box> (1)", "[PutIn] <plate> (2) <box> (1)"})
    expected.emplace_back(one);
  expected.insert(expected.end(), pie.begin(), pie.end());
  EXPECT_EQ(*lines, expected);
}

TEST(VirtualhomeProgram, ThingsThatRestOnEachOtherHaveTheirLinesOnce) {
  Scene start;
  start.nodes = {thing("tray_1", Predicate::Clean), thing("mug_2", Predicate::Clean), thing("cup_3", Predicate::Clean)};
  start.edges = {
      {Predicate::On, "mug_2", "tray_1"}, {Predicate::On, "cup_3", "mug_2"}, {Predicate::On, "mug_2", "cup_3"}};
  DemonstrationRecord demonstration;
  demonstration.steps = {step("go_to", {"tray_1"}), holding(step("pick_up", {"tray_1"}), {"tray_1"})};
  const auto lines =
      virtualhome_program(demonstration, start, {{"tray_1", "tray_1"}, {"mug_2", "mug_2"}, {"cup_3", "cup_3"}});
  ASSERT_TRUE(lines) << format(lines.error());
  EXPECT_THAT(*lines, ElementsAre("[Walk] <tray> (1)", "[Grab] <tray> (1)", "[Walk] <mug> (2)", "[Grab] <mug> (2)",
                                  "[PutBack] <mug> (2) <tray> (1)", "[Walk] <cup> (3)", "[Grab] <cup> (3)",
                                  "[Walk] <mug> (2)", "[PutBack] <cup> (3) <mug> (2)"));
}

TEST(VirtualhomeProgram, LeavesOutStepsThatFailed) {
  const auto lines = program({step("open", {"fridge_4"}, false), step("close", {"fridge_4"})});
  ASSERT_TRUE(lines) << format(lines.error());
  EXPECT_THAT(*lines, ElementsAre("[Walk] <fridge> (9)", "[Close] <fridge> (9)"));
}

TEST(VirtualhomeProgram, SaysWhatVirtualHomeCannotDo) {
  const auto sliced = program({step("slice", {"mug_1"})});
  ASSERT_FALSE(sliced);
  EXPECT_THAT(sliced.error().message, HasSubstr("no action slice"));
  const auto unknown = program({step("open", {"cabinet_7"})});
  ASSERT_FALSE(unknown);
  EXPECT_THAT(unknown.error().message, HasSubstr("cabinet_7 is not in the graph"));
}

}  // namespace
}  // namespace unietp
