// The rules of the modes, one by one: what an agent may name, the feedback when it may not, and when an episode ends.
#include <algorithm>

#include <gtest/gtest.h>

#include "core/rng.h"
#include "simulation/mode_episode.h"
#include "simulation/relations.h"
#include "tests/simulation/kitchen.h"

namespace unietp {
namespace {

Command say(std::string action) { return {std::move(action), {}}; }
Command say(std::string action, std::string id) { return {std::move(action), {{std::move(id), std::nullopt}}}; }
Command say(std::string action, const PixelBox& box) { return {std::move(action), {{"", box}}}; }

class AnEpisode : public ::testing::Test {
 protected:
  AnEpisode() : knowledge_(testing::kitchen_knowledge()), profile_(testing::kitchen_profile()) {}

  /// The kitchen with a second mug in the closed fridge; the agent looks away from everything.
  ModeEpisode episode(Mode mode) {
    Scene scene = testing::kitchen();
    testing::add(scene, "mug_2", knowledge_, "Mug", 4.4, 3.35, 0.022);
    scene.edges = read_relations(scene);
    edit_node(scene, "sink_1")->states.set({Predicate::PowerOff, ""});
    scene.agent.pitch = -0.5;
    return {*World::create(scene, knowledge_, profile_), mode};
  }
  static void expect_refused(ModeEpisode& episode, const Command& command, Failure failure) {
    SCOPED_TRACE(to_text(command));
    const Scene before = episode.world().scene();
    const int steps = episode.steps(), failures = episode.failures();
    const Outcome outcome = episode.step(command);
    EXPECT_FALSE(outcome.success);
    EXPECT_EQ(name_of(outcome.failure), name_of(failure)) << outcome.feedback;
    EXPECT_FALSE(outcome.feedback.empty());
    EXPECT_TRUE(episode.world().scene() == before);
    EXPECT_EQ(episode.steps(), steps + 1);
    EXPECT_EQ(episode.failures(), failures + 1);
  }
  static void expect_done(ModeEpisode& episode, const Command& command) {
    SCOPED_TRACE(to_text(command));
    const Outcome outcome = episode.step(command);
    EXPECT_TRUE(outcome.success) << name_of(outcome.failure) << ": " << outcome.feedback;
  }
  static const VisibleObject* seen(const ModeEpisode& episode, const std::string& id) {
    for (const VisibleObject& object : episode.visible()) {
      if (object.id == id) return &object;
    }
    return nullptr;
  }

  Knowledge knowledge_;
  Profile profile_;
};

TEST_F(AnEpisode, RefusesInEveryModeWhatIsNoActionAndCountsIt) {
  for (const Mode mode : kModes) {
    ModeEpisode session = episode(mode);
    expect_refused(session, say("fly"), Failure::InvalidAction);
    expect_refused(session, say("pick_up"), Failure::InvalidArgument);
    expect_refused(session, say("turn_left", "kitchen_1"), Failure::InvalidArgument);
    expect_refused(session, say("pick_up", "unicorn_1"),
                   mode == Mode::M2 ? Failure::NotSeenYet : Failure::InvalidArgument);
    expect_done(session, say("turn_left"));
    EXPECT_EQ(session.steps(), 5);
    EXPECT_EQ(session.failures(), 4);
  }
}

TEST_F(AnEpisode, OffersCompositeActionsInM1Alone) {
  ModeEpisode m1 = episode(Mode::M1), m2 = episode(Mode::M2), m3 = episode(Mode::M3);
  EXPECT_EQ(m1.step(say("heat_with", "microwave_1")).failure, Failure::NotHolding);
  expect_refused(m2, say("heat_with", "microwave_1"), Failure::NotOffered);
  expect_refused(m3, say("heat_with", PixelBox{0, 0, 400, 400}), Failure::NotOffered);
}

TEST_F(AnEpisode, LetsAnAgentInM1NameAnythingByItsIdAndNothingByABox) {
  ModeEpisode m1 = episode(Mode::M1);
  expect_done(m1, say("go_to", "mug_1"));
  expect_done(m1, say("pick_up", "mug_1"));
  expect_refused(m1, say("go_to", PixelBox{0, 0, 400, 400}), Failure::InvalidArgument);
}

TEST_F(AnEpisode, LetsAnAgentInM2GoOnlyToRoomsFurnitureAndWhatIsInView) {
  ModeEpisode m2 = episode(Mode::M2);
  ASSERT_EQ(seen(m2, "mug_1"), nullptr);
  expect_refused(m2, say("go_to", "mug_1"), Failure::NotInView);
  expect_refused(m2, say("pick_up", "mug_1"), Failure::NotSeenYet);
  expect_refused(m2, say("go_to", PixelBox{0, 0, 400, 400}), Failure::InvalidArgument);
  expect_done(m2, say("go_to", "kitchen_1"));
  expect_done(m2, say("go_to", "diningtable_1"));
  ASSERT_NE(seen(m2, "mug_1"), nullptr);
  expect_done(m2, say("go_to", "mug_1"));
  expect_done(m2, say("go_to", "fridge_1"));
  ASSERT_EQ(seen(m2, "mug_1"), nullptr);
  expect_refused(m2, say("go_to", "mug_1"), Failure::NotInView);
  EXPECT_EQ(m2.step(say("pick_up", "mug_1")).failure, Failure::TooFar) << "it was seen, so the world is asked";
  expect_refused(m2, say("pick_up", "mug_2"), Failure::NotSeenYet);
  expect_done(m2, say("open", "fridge_1"));
  ASSERT_NE(seen(m2, "mug_2"), nullptr);
  expect_done(m2, say("go_to", "mug_2"));
  expect_done(m2, say("pick_up", "mug_2"));
  EXPECT_EQ(m2.step(say("go_to", "mug_2")).failure, Failure::InvalidArgument) << "it is in the hand";
}

TEST_F(AnEpisode, TakesInM3RoomsByIdAndObjectsByTheBoxThatAgreesBestWithThePicture) {
  ModeEpisode m3 = episode(Mode::M3);
  expect_done(m3, say("go_to", "kitchen_1"));
  expect_refused(m3, say("go_to", "diningtable_1"), Failure::InvalidArgument);
  expect_refused(m3, say("turn_to", "kitchen_1"), Failure::InvalidArgument);
  expect_refused(m3, say("go_to", PixelBox{1, 1, 0, 0}), Failure::NoObjectThere);
  expect_refused(m3, say("go_to", PixelBox{-900, -900, -800, -800}), Failure::NoObjectThere);
  for (int turn = 0; turn < 12 && seen(m3, "diningtable_1") == nullptr; ++turn) expect_done(m3, say("turn_left"));
  const VisibleObject* table = seen(m3, "diningtable_1");
  ASSERT_NE(table, nullptr);
  PixelBox rough = table->box;
  rough[0] -= (rough[2] - rough[0]) / 10;
  rough[3] -= (rough[3] - rough[1]) / 10;
  expect_done(m3, say("go_to", rough));
  const Vec2 table_at = find_node(m3.world().scene(), "diningtable_1")->pose.position.head<2>();
  EXPECT_LT((m3.world().scene().agent.position - table_at).norm(), 2.0);
}

TEST_F(AnEpisode, NamesInM3NoIdInItsFeedback) {
  ModeEpisode m3 = episode(Mode::M3);
  expect_done(m3, say("go_to", "kitchen_1"));
  for (int turn = 0; turn < 12 && seen(m3, "fridge_1") == nullptr; ++turn) expect_done(m3, say("turn_left"));
  ASSERT_NE(seen(m3, "fridge_1"), nullptr);
  const Outcome outcome = m3.step(say("pick_up", seen(m3, "fridge_1")->box));
  EXPECT_EQ(outcome.failure, Failure::NotPickupable);
  EXPECT_EQ(outcome.feedback, "The fridge cannot be picked up.");
}

/// Moves what it holds about until it hits things, some of which the picture does not show.
TEST_F(AnEpisode, NamesInM3NothingThatTheHandHitsOutOfThePicture) {
  Rng rng(4);
  ModeEpisode m1 = episode(Mode::M1);
  expect_done(m1, say("go_to", "mug_1"));
  expect_done(m1, say("pick_up", "mug_1"));
  int hidden = 0, named = 0;
  for (int i = 0; i < 400; ++i) {
    if (i % 20 == 0) (void)m1.step(say("go_to", rng.pick(m1.world().nodes()).id));
    ModeEpisode m3(m1.world(), Mode::M3);
    for (const char* turn : {"turn_left", "look_up"}) {
      for (std::uint64_t times = rng.below(4); times > 0; --times) (void)m3.step(say(turn));
    }
    for (int k = 0; k < 8; ++k) {
      static const std::vector<std::string> kMoves{"move_hand_left", "move_hand_right", "move_hand_forward",
                                                   "move_forward"};
      const Outcome outcome = m3.step(say(rng.pick(kMoves)));
      if (outcome.failure != Failure::Blocked) continue;
      ++(outcome.feedback.find("something") == std::string::npos ? named : hidden);
      for (const Node& node : m3.world().scene().nodes) {
        const std::string name = knowledge_.find(node.category)->display;
        const bool shown = std::any_of(m3.visible().begin(), m3.visible().end(), [&](const VisibleObject& object) {
          return find_node(m3.world().scene(), object.id)->category == node.category;
        });
        if (shown || node.category == "Mug") continue;  // which it holds
        EXPECT_EQ(outcome.feedback.find(" " + name), std::string::npos) << outcome.feedback;
      }
    }
  }
  EXPECT_GT(hidden, 0);
  EXPECT_GT(named, 0);
}

TEST_F(AnEpisode, SaysAnActionAsTheModeWantsIt) {
  const Action go{ActionType::GoTo, {"mug_1"}}, room{ActionType::GoTo, {"kitchen_1"}};
  ModeEpisode m1 = episode(Mode::M1), m2 = episode(Mode::M2), m3 = episode(Mode::M3);
  EXPECT_EQ(m1.command_for(go), say("go_to", "mug_1"));
  EXPECT_EQ(m2.command_for(go), std::nullopt);
  EXPECT_EQ(m3.command_for(go), std::nullopt);
  EXPECT_EQ(m3.command_for(room), say("go_to", "kitchen_1"));
  for (int turn = 0; turn < 12 && seen(m3, "fridge_1") == nullptr; ++turn) expect_done(m3, say("turn_left"));
  ASSERT_NE(seen(m3, "fridge_1"), nullptr);
  EXPECT_EQ(m3.command_for({ActionType::GoTo, {"fridge_1"}}), say("go_to", seen(m3, "fridge_1")->box));
  EXPECT_EQ(m2.command_for({ActionType::HeatWith, {"microwave_1"}}), std::nullopt);
}

TEST_F(AnEpisode, EndsAtTheLimitsOfItsModeOrWhenItIsStopped) {
  for (const Mode mode : kModes) {
    SCOPED_TRACE(name_of(mode));
    const StepLimits limits = rules_of(mode).limits;
    ModeEpisode turning = episode(mode), failing = episode(mode), stopping = episode(mode);
    for (int i = 0; i < limits.steps; ++i) {
      EXPECT_FALSE(turning.over());
      expect_done(turning, say("turn_left"));
    }
    for (int i = 0; i < limits.failures; ++i) {
      EXPECT_FALSE(failing.over());
      expect_refused(failing, say("fly"), Failure::InvalidAction);
    }
    expect_done(stopping, say("stop"));
    for (ModeEpisode* ended : {&turning, &failing, &stopping}) {
      EXPECT_TRUE(ended->over());
      const int steps = ended->steps();
      EXPECT_EQ(ended->step(say("turn_left")).failure, Failure::InvalidAction);
      EXPECT_EQ(ended->steps(), steps) << "after the end nothing counts";
    }
  }
  EXPECT_EQ(rules_of(Mode::M2).limits.steps, 50);
  EXPECT_EQ(rules_of(Mode::M3).limits.steps, 150);
  EXPECT_EQ(rules_of(Mode::M3).limits.failures, 30);
}

TEST_F(AnEpisode, BeginsWithTheGlobalInformationOfItsMode) {
  const Scene scene = testing::kitchen();
  const auto m1 = global_information(scene, rules_of(Mode::M1)), m2 = global_information(scene, rules_of(Mode::M2));
  const auto m3 = global_information(scene, rules_of(Mode::M3));
  EXPECT_EQ(m1.rooms, std::vector<std::string>{"kitchen_1"});
  EXPECT_EQ(m1.furniture.size() + m1.movables.size(), scene.nodes.size());
  EXPECT_EQ(m2.furniture, m1.furniture);
  EXPECT_TRUE(m2.movables.empty());
  EXPECT_EQ(m3.rooms, m1.rooms);
  EXPECT_TRUE(m3.furniture.empty() && m3.movables.empty());
  EXPECT_TRUE(rules_of(Mode::M1).boxes && rules_of(Mode::M2).boxes && !rules_of(Mode::M3).boxes);
}

TEST_F(AnEpisode, RunsATapWhileItsSinkIsOn) {
  ModeEpisode m2 = episode(Mode::M2);
  ASSERT_NE(find_node(m2.world().scene(), "sink_1"), nullptr);
  expect_done(m2, say("go_to", "diningtable_1"));
  expect_done(m2, say("pick_up", "mug_1"));
  expect_done(m2, say("go_to", "sink_1"));
  expect_done(m2, say("place_in", "sink_1"));
  const auto mug = [&] { return find_node(m2.world().scene(), "mug_1"); };
  EXPECT_FALSE(mug()->states.has(Predicate::Filled));
  expect_done(m2, say("turn_on", "sink_1"));
  EXPECT_TRUE(mug()->states.has({Predicate::Filled, "water"}));
  EXPECT_TRUE(mug()->states.has(Predicate::Clean));
}

TEST(PixelBoxes, OverlapByWhatBothHoldOfWhatEitherHolds) {
  EXPECT_DOUBLE_EQ(overlap_of({0, 0, 9, 9}, {0, 0, 9, 9}), 1);
  EXPECT_DOUBLE_EQ(overlap_of({0, 0, 9, 9}, {5, 0, 14, 9}), 1.0 / 3);
  EXPECT_DOUBLE_EQ(overlap_of({0, 0, 9, 9}, {10, 0, 14, 9}), 0);
  EXPECT_DOUBLE_EQ(overlap_of({0, 0, 0, 0}, {0, 0, 1, 0}), 0.5);
  EXPECT_DOUBLE_EQ(overlap_of({3, 0, 0, 0}, {0, 0, 5, 5}), 0) << "a box turned inside out holds nothing";
}

}  // namespace
}  // namespace unietp
