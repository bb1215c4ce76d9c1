// The table action x simulator x profile, row by row: an action succeeds when its needs are met, fails in its own way
// for each need that is not, and a failure changes nothing.
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "simulation/feedback.h"
#include "simulation/world.h"
#include "tests/simulation/action_rows.h"
#include "tests/simulation/kitchen.h"

namespace unietp {
namespace {

using testing::ActionRow;

class ActionTable : public ::testing::TestWithParam<std::tuple<Simulator, ActionProfile>> {
 protected:
  ActionTable()
      : simulator_(std::get<0>(GetParam())),
        knowledge_(testing::kitchen_knowledge(simulator_)),
        profile_(*load_profile(UNIETP_SOURCE_DIR "/data/simulators", simulator_, std::get<1>(GetParam()))) {}

  World world_of(const Scene& scene) {
    auto world = World::create(scene, knowledge_, profile_);
    EXPECT_TRUE(world) << format(world.error());
    return std::move(*world);
  }
  /// The world in which a row's action is tried.
  World start_of(const ActionRow& row) {
    World world = world_of(testing::wide_kitchen(simulator_));
    for (const Action& action : row.before) {
      const ActionResult outcome = world.step(action);
      EXPECT_TRUE(outcome.success) << to_text(action) << ": " << feedback_with_ids(outcome.detail);
    }
    if (!row.alter) return world;
    Scene scene = world.scene();
    row.alter(scene);
    return world_of(scene);
  }
  static Action action_of(const ActionRow& row) {
    return {row.action, row.target.empty() ? std::vector<std::string>{} : std::vector<std::string>{row.target}};
  }
  void expect_failure(World& world, const Action& action, Failure failure) {
    const Scene before = world.scene();
    const bool stopped = world.stopped();
    const ActionResult outcome = world.step(action);
    EXPECT_FALSE(outcome.success);
    EXPECT_EQ(name_of(outcome.failure), name_of(failure)) << feedback_with_ids(outcome.detail);
    EXPECT_NE(outcome.detail.cause, FailureCause::None);
    EXPECT_TRUE(world.scene() == before) << "a failure changed something";
    EXPECT_EQ(world.stopped(), stopped);
  }

  Simulator simulator_;
  Knowledge knowledge_;
  Profile profile_;
};

TEST_P(ActionTable, EveryRowGoesAsItsNeedsAre) {
  std::map<ActionType, std::set<Failure>> covered;
  for (const ActionRow& row : testing::action_rows()) {
    if (!profile_.offers(row.action)) continue;
    // Whoever cannot sit is never seated, and so on: what only some `wide` profiles have.
    if (row.failure == Failure::Seated && !profile_.offers(ActionType::SitOn)) continue;
    if (row.failure == Failure::NotPluggedIn && !profile_.power_needs_plug) continue;
    SCOPED_TRACE(to_text(action_of(row)) + " -> " + std::string(name_of(row.failure)));
    covered[row.action].insert(row.failure);
    World world = start_of(row);
    if (row.failure != Failure::None) {
      expect_failure(world, action_of(row), row.failure);
      continue;
    }
    const Scene before = world.scene();
    const ActionResult outcome = world.step(action_of(row));
    EXPECT_TRUE(outcome.success) << feedback_with_ids(outcome.detail);
    EXPECT_EQ(outcome.detail.cause, FailureCause::None);
    EXPECT_TRUE(row.effect ? row.effect(world.scene()) : !(world.scene() == before)) << "no effect";
  }
  for (const auto list : {all_actions(), extension_actions()}) {
    for (const ActionInfo& action : list) {
      if (!profile_.offers(action.type)) continue;
      const auto failures = failures_of(action);
      std::set<Failure> needs(failures.begin(), failures.end());
      needs.insert(Failure::None);
      if (!profile_.offers(ActionType::SitOn)) needs.erase(Failure::Seated);
      if (!profile_.power_needs_plug) needs.erase(Failure::NotPluggedIn);
      EXPECT_EQ(covered[action.type], needs) << action.name << ": a need has no row, or a row is of no need";
    }
  }
}

TEST_P(ActionTable, WhatIsNotOfferedAndWhatNamesNothingFails) {
  World world = world_of(testing::wide_kitchen(simulator_));
  for (const auto list : {all_actions(), extension_actions()}) {
    for (const ActionInfo& action : list) {
      SCOPED_TRACE(action.name);
      const bool takes_one = action.argument != ActionArgument::None;
      const std::vector<std::string> right = takes_one ? std::vector<std::string>{"mug_1"} : std::vector<std::string>{};
      if (!profile_.offers(action.type)) {
        expect_failure(world, {action.type, right}, Failure::NotOffered);
        continue;
      }
      expect_failure(world, {action.type, {"mug_1", "plate_1"}}, Failure::InvalidArgument);
      if (takes_one) {
        expect_failure(world, {action.type, {}}, Failure::InvalidArgument);
        expect_failure(world, {action.type, {"unicorn_1"}}, Failure::InvalidArgument);
      } else {
        expect_failure(world, {action.type, {"mug_1"}}, Failure::InvalidArgument);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ActionTable,
                         ::testing::Combine(::testing::ValuesIn(kSimulators),
                                            ::testing::Values(ActionProfile::Unietp, ActionProfile::Wide)),
                         [](const auto& row) {
                           return std::string(name_of(std::get<0>(row.param))) + "_" +
                                  std::string(name_of(std::get<1>(row.param)));
                         });

}  // namespace
}  // namespace unietp
