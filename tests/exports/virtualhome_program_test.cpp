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
