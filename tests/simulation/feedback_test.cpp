// the feedback of failed actions: with ids in M1; in M2 and M3 in words that are the same whatever the ids.
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "simulation/feedback.h"
#include "simulation/mode_episode.h"
#include "tests/simulation/action_rows.h"
#include "tests/simulation/kitchen.h"

namespace unietp {
namespace {

using testing::ActionRow;
using Ids = std::map<std::string, std::string>;  // from those of the kitchen to others

/// Ids that look like words of the sentences, like categories, or like no word at all; then numbered ones.
std::string odd_id(std::size_t i) {
  static const std::vector<std::string> kOdd{"a",     "the", "fridge", "mug-1",   "is",     "in",    "hand", "You",
                                             "mug 1", "to.", "1",      "{other}", "closed", "Küche", "mug",  "There"};
  return i < kOdd.size() ? kOdd[i] : "object-" + std::to_string(i);
}

Ids odd_ids(const Scene& scene) {
  Ids ids;
  for (const Node& node : scene.nodes) ids.emplace(node.id, odd_id(ids.size()));
  for (const Room& room : scene.rooms) ids.emplace(room.id, "room-" + std::to_string(ids.size()));
  return ids;
}

Scene renamed(Scene scene, const Ids& ids) {
  const auto rename = [&](std::string& id) {
    if (const auto found = ids.find(id); found != ids.end()) id = found->second;  // not "" or "agent"
  };
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    rename(scene.nodes.edit(i).id);
    rename(scene.nodes.edit(i).slice_of);
  }
  for (Room& room : scene.rooms) rename(room.id);
  for (std::string& id : scene.agent.held) rename(id);
  EdgeSet edges;
  for (Edge edge : scene.edges) {
    rename(edge.from);
    rename(edge.to);
    edges.insert(edge);
  }
  scene.edges = std::move(edges);
  return scene;
}

/// Whether the text has the id as a word of its own.
bool has_word(const std::string& text, const std::string& id) {
  const auto in_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-'; };
  for (std::size_t at = text.find(id); at != std::string::npos; at = text.find(id, at + 1)) {
    const std::size_t end = at + id.size();
    if ((at == 0 || !in_word(text[at - 1])) && (end == text.size() || !in_word(text[end]))) return true;
  }
  return false;
}

void expect_no_id(const Scene& scene, const std::string& feedback) {
  for (const Node& node : scene.nodes) EXPECT_FALSE(has_word(feedback, node.id)) << feedback;
  for (const Room& room : scene.rooms) EXPECT_FALSE(has_word(feedback, room.id)) << feedback;
}

/// A kitchen of a simulator, and the same with other ids.
class Feedback : public ::testing::Test {
 protected:
  struct Setting {
    Simulator simulator;
    ActionProfile actions;
    Knowledge knowledge = testing::kitchen_knowledge(simulator);
    Profile profile = testing::kitchen_profile(simulator, actions);
    World world_of(const Scene& scene) const { return *World::create(scene, knowledge, profile); }
  };
  static std::vector<Setting> settings() {
    return {{Simulator::Ai2thor, ActionProfile::Unietp},
            {Simulator::Behavior, ActionProfile::Unietp},
            {Simulator::Virtualhome, ActionProfile::Wide},
            {Simulator::Behavior, ActionProfile::Wide},
            {Simulator::Ai2thor, ActionProfile::Wide}};
  }
  /// The scene in which a row's action fails.
  static Scene start_of(const Setting& setting, const ActionRow& row) {
    World world = setting.world_of(testing::wide_kitchen(setting.simulator));
    for (const Action& action : row.before) EXPECT_TRUE(world.step(action).success) << to_text(action);
    Scene scene = world.scene();
    if (row.alter) row.alter(scene);
    return scene;
  }
  static Action action_of(const ActionRow& row, const Ids& ids = {}) {
    if (row.target.empty()) return {row.action, {}};
    return {row.action, {ids.empty() ? row.target : ids.at(row.target)}};
  }
  /// What agents of M2 and M3 are told is the same with any ids, and has none of them; in M1 it names the target.
  void expect_without_ids(const Scene& scene, const ActionResult& result, const ActionResult& with_odd_ids) {
    for (const Mode mode : {Mode::M2, Mode::M3}) {
      const Outcome outcome = outcome_in(mode, result);
      EXPECT_FALSE(outcome.feedback.empty());
      EXPECT_EQ(outcome.feedback.find_first_of("{}"), std::string::npos) << outcome.feedback;
      EXPECT_EQ(outcome_in(mode, with_odd_ids).feedback, outcome.feedback);
      expect_no_id(scene, outcome.feedback);
    }
    seen_.insert(result.failure);
  }
  void expect_failure(const Scene& scene, const Outcome& outcome, Failure failure) {
    EXPECT_EQ(name_of(outcome.failure), name_of(failure)) << outcome.feedback;
    expect_no_id(scene, outcome.feedback);
    seen_.insert(outcome.failure);
  }

  std::set<Failure> seen_;
};

Command say(std::string action) { return {std::move(action), {}}; }
Command say(std::string action, std::string id) { return {std::move(action), {{std::move(id), std::nullopt}}}; }
Command say(std::string action, const PixelBox& box) { return {std::move(action), {{"", box}}}; }

TEST_F(Feedback, InM2AndM3HoldsNoIdForAnyKindOfFailureAndAnyIds) {
  for (const Setting& setting : settings()) {
    for (const ActionRow& row : testing::action_rows()) {
      if (row.failure == Failure::None || !setting.profile.offers(row.action)) continue;
      SCOPED_TRACE(std::string(name_of(setting.simulator)) + " " + to_text(action_of(row)) + " -> " +
                   std::string(name_of(row.failure)));
      const Scene scene = start_of(setting, row);
      const Ids ids = odd_ids(scene);
      World world = setting.world_of(scene), odd = setting.world_of(renamed(scene, ids));
      for (const Mode mode : {Mode::M2, Mode::M3}) {
        ModeEpisode episode(world, mode), odd_episode(odd, mode);
        const auto command = episode.command_for(action_of(row)),
                   odd_command = odd_episode.command_for(action_of(row, ids));
        if (!command || !odd_command) continue;
        const Outcome outcome = episode.step(*command);
        EXPECT_EQ(odd_episode.step(*odd_command).feedback, outcome.feedback);
        expect_no_id(scene, outcome.feedback);
      }
      const ActionResult result = world.step(action_of(row)), odd_result = odd.step(action_of(row, ids));
      if (result.success) continue;  // a need that only other profiles have
      EXPECT_EQ(odd_result.failure, result.failure);
      expect_without_ids(scene, result, odd_result);
    }
  }
  // What the rules of a mode refuse before the world is asked, and what the tables of rows leave out.
  const Setting setting = settings().front();
  Scene scene = testing::kitchen();
  testing::add(scene, "mug_2", setting.knowledge, "Mug", 4.4, 3.35, 0.022);
  scene.edges = read_relations(scene);
  scene.agent.pitch = -0.5;
  ModeEpisode m2(setting.world_of(scene), Mode::M2), m3(setting.world_of(scene), Mode::M3);
  expect_failure(scene, m2.step(say("mug_2")), Failure::InvalidAction);
  expect_failure(scene, m2.step(say("heat_with", "microwave_1")), Failure::NotOffered);
  expect_failure(scene, m2.step(say("sit_on", "fridge_1")), Failure::NotOffered);
  expect_failure(scene, m2.step(say("turn_left", "mug_1")), Failure::InvalidArgument);
  expect_failure(scene, m2.step(say("pick_up", "mug_2")), Failure::NotSeenYet);
  expect_failure(scene, m2.step(say("go_to", "mug_2")), Failure::NotInView);
  expect_failure(scene, m2.step(say("go_to", PixelBox{0, 0, 9, 9})), Failure::InvalidArgument);
  expect_failure(scene, m2.step(say("pick_up", "unicorn_1")), Failure::NotSeenYet);
  expect_failure(scene, m3.step(say("mug_2")), Failure::InvalidAction);
  expect_failure(scene, m3.step(say("go_to", "mug_2")), Failure::InvalidArgument);
  expect_failure(scene, m3.step(say("go_to", PixelBox{-9, -9, -8, -8})), Failure::NoObjectThere);
  expect_failure(scene, m3.step(say("turn_left", "kitchen_1")), Failure::InvalidArgument);
  for (std::size_t kind = 1; kind < kFailureCount; ++kind) {
    EXPECT_TRUE(seen_.contains(static_cast<Failure>(kind))) << name_of(static_cast<Failure>(kind));
  }
}

TEST_F(Feedback, OfARoomThatCannotBeWalkedIntoNamesItByItsType) {
  const Setting setting = settings().front();
  const ActionRow* boxed_in = nullptr;
  const auto rows = testing::action_rows();
  for (const ActionRow& row : rows) {
    if (row.action == ActionType::GoTo && row.failure == Failure::NoStandingPlace) boxed_in = &row;
  }
  ASSERT_NE(boxed_in, nullptr);
  Scene scene = start_of(setting, *boxed_in);
  scene.rooms.push_back({"x-17", "living_room", {{5, 0}, {9, 0}, {9, 4}, {5, 4}}});
  World world = setting.world_of(scene);
  const ActionResult result = world.step({ActionType::GoTo, {"x-17"}});
  EXPECT_EQ(outcome_in(Mode::M1, result).feedback, "There is no way to walk into x-17.");
  EXPECT_EQ(outcome_in(Mode::M2, result).feedback, "There is no way to walk into the living room.");
}

TEST_F(Feedback, FillsInEveryCauseInEveryMode) {
  for (std::size_t i = 1; i < kFailureCauseCount; ++i) {
    const FailureCauseInfo& about = info(static_cast<FailureCause>(i));
    SCOPED_TRACE(about.sentence);
    const ActionResult result = failed({about.cause, {"x-1", "the mug"}, {"x-2", "the shelf"}, {}});
    EXPECT_EQ(result.failure, about.failure);
    const bool names_one = about.sentence.find("{object}") != std::string_view::npos;
    const bool names_two = about.sentence.find("{other}") != std::string_view::npos;
    for (const Mode mode : kModes) {
      const std::string feedback = outcome_in(mode, result).feedback;
      EXPECT_EQ(feedback.back(), '.');
      EXPECT_EQ(feedback.find_first_of("{}"), std::string::npos) << feedback;
      EXPECT_EQ(has_word(feedback, "x-1"), mode == Mode::M1 && names_one) << feedback;
      EXPECT_EQ(has_word(feedback, "x-2"), mode == Mode::M1 && names_two) << feedback;
      EXPECT_EQ(feedback.find(" mug") != std::string::npos, mode != Mode::M1 && names_one) << feedback;
    }
  }
}

TEST_F(Feedback, OfACompositeActionNamesItsTool) {
  const ActionResult result =
      failed({FailureCause::NoFreePlaceInside, {"sink_1", "the sink"}, {}, {"sink_1", "the sink"}});
  EXPECT_EQ(outcome_in(Mode::M1, result).feedback,
            "Could not use sink_1: There is no free place in reach inside sink_1.");
  EXPECT_EQ(outcome_in(Mode::M3, result).feedback,
            "Could not use the sink: There is no free place in reach inside the sink.");
}

}  // namespace
}  // namespace unietp
