// A planted failure of each class.
#include "scores/failure_class.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scores/episode_score.h"
#include "tests/environment/house_task.h"
#include "tests/scores/played_episode.h"

namespace unietp {
namespace {

using ::testing::Contains;
using testing::house_task;
using ::testing::IsEmpty;
using testing::played;
using testing::PlayedEpisode;
using testing::say;
using Replies = std::vector<std::string>;

const char* const kMugOnTable = "(exists (?x - Mug) (exists (?y - SideTable) (at-end (on ?x ?y))))";

std::vector<std::string> classes(const PlayedEpisode& episode, const SharedTask& task,
                                 std::optional<int> shortest = std::nullopt) {
  EXPECT_THAT(differences(episode.record, episode.replayed, *task), IsEmpty());
  return finalize_score(score_episode(episode.record, episode.replayed, *task, false), shortest).classes;
}

/// All classes of what an agent says in M1.
std::vector<std::string> classes(const std::string& goal, const Replies& replies,
                                 std::optional<int> shortest = std::nullopt) {
  const SharedTask task = house_task(goal);
  return classes(played(task, settings_for(Mode::M1), replies), task, shortest);
}
std::string first(const std::vector<std::string>& found) { return found.empty() ? "success" : found.front(); }

Replies carry(const std::string& thing, const std::string& place) {
  return {say("go_to", thing), say("pick_up", thing), say("go_to", place), say("place_on", place)};
}
Replies operator+(Replies all, const Replies& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}
Replies times(int count, const std::string& reply) { return {static_cast<std::size_t>(count), reply}; }

TEST(FailureClasses, AreNoneOfASuccess) {
  EXPECT_EQ(first(classes(kMugOnTable, carry("mug_1", "sidetable_1") + Replies{"stop"}, 5)), "success");
}

TEST(FailureClasses, TellWhatCouldNotBeHad) {
  const SharedTask task = house_task(kMugOnTable);
  auto episode = played(task, settings_for(Mode::M1), {say("turn_left")}, true);
  for (const EpisodeErrorKind kind :
       {EpisodeErrorKind::RateLimit, EpisodeErrorKind::Server, EpisodeErrorKind::Connection, EpisodeErrorKind::Timeout,
        EpisodeErrorKind::Rejected, EpisodeErrorKind::Policy, EpisodeErrorKind::Simulator}) {
    episode.record.error->kind = kind;
    EXPECT_EQ(first(classes(episode, task)), "errored: " + std::string(name_of(kind)));
  }
}

TEST(FailureClasses, TellWhatWasNoOutput) {
  EXPECT_EQ(first(classes(kMugOnTable, times(10, "I would pick up the mug."))), "output: no_json");
  EXPECT_EQ(first(classes(kMugOnTable, times(10, say("fly")))), "output: unknown_action");
  EXPECT_EQ(first(classes(kMugOnTable, times(10, say("pick_up", "mug_77")))), "output: bad_argument");
  EXPECT_EQ(first(classes(kMugOnTable, times(10, R"({"action": "pick_up", "args": [1]})"))), "output: bad_argument");
  const SharedTask task = house_task(kMugOnTable);
  auto cut = played(task, settings_for(Mode::M1), times(10, R"({"action": "pick)"));
  for (EpisodeStep& step : cut.record.steps) step.finish = "length";
  EXPECT_EQ(first(classes(cut, task)), "output: truncated");
  // A slip among good actions is not why.
  EXPECT_EQ(first(classes(kMugOnTable, Replies{"hm"} + carry("apple_1", "sidetable_1") + Replies{"stop"}, 5)),
            "grounding: wrong_category");
}

TEST(FailureClasses, TellAStopThatCameTooEarlyOrNever) {
  EXPECT_EQ(first(classes(kMugOnTable, {"stop"}, 5)), "stop: premature");
  EXPECT_EQ(first(classes(kMugOnTable, {"stop"})), "stop: premature");
  EXPECT_EQ(first(classes(kMugOnTable, carry("mug_1", "sidetable_1") + Replies{say("pick_up", "mug_1"), "stop"}, 5)),
            "stop: missed");
}

TEST(FailureClasses, TellALimitThatWasReached) {
  EXPECT_EQ(first(classes(kMugOnTable, times(50, say("turn_left")))), "limit: loop");
  Settings settings = settings_for(Mode::M1);
  settings.rules.limits.steps = 4;
  const SharedTask task =
      house_task("(and (exists (?f - Fridge) (at-end (open ?f))) (exists (?m - Mug) (at-end (held ?m))))");
  const auto short_of =
      played(task, settings, {say("turn_left"), say("turn_right"), say("go_to", "fridge_1"), say("open", "fridge_1")});
  EXPECT_EQ(first(classes(short_of, task)), "limit: steps");
  // Ten failures of five kinds.
  const Replies mixed{say("open", "plate_1"),         say("pick_up", "television_1"),
                      say("place_on", "sidetable_1"), say("pick_up", "plate_2"),
                      say("turn_on", "mug_1"),        say("close", "plate_1"),
                      say("pick_up", "sidetable_1"),  say("drop"),
                      say("pick_up", "lamp_1"),       say("turn_off", "mug_1")};
  EXPECT_EQ(first(classes(kMugOnTable, mixed)), "limit: failures");
}

TEST(FailureClasses, TellATargetThatWasNeverShown) {
  EXPECT_EQ(
      first(classes("(exists (?x - Lamp) (at-end (power_on ?x)))", {say("turn_left"), say("turn_right"), "stop"})),
      "exploration: target_not_shown");
}

TEST(FailureClasses, TellTheWrongThing) {
  const std::string clean = "(exists (?x - (Mug :where (clean ?x))) (exists (?y - SideTable) (at-end (on ?x ?y))))";
  const Replies look{say("go_to", "mug_3")};
  EXPECT_EQ(first(classes(clean, look + carry("mug_1", "sidetable_1") + Replies{"stop"}, 5)),
            "grounding: wrong_instance");
  EXPECT_EQ(first(classes(clean, carry("mug_3", "sidetable_1") + Replies{"stop"}, 5)), "success");
  EXPECT_EQ(first(classes(kMugOnTable, carry("apple_1", "sidetable_1") + Replies{"stop"}, 5)),
            "grounding: wrong_category");
  const SharedTask task = house_task("(exists (?x - Mug) (at-end (held ?x)))");
  Replies boxes{say("go_to", "kitchen_1")};
  for (int i = 0; i < 30; ++i)
    boxes.push_back(R"({"action": "pick_up", "args": [{"bbox": [)" + std::to_string(i) + ", 0, " +
                    std::to_string(i + 1) + R"(, 1]}]})");
  const auto blind = played(task, settings_for(Mode::M3), boxes);
  EXPECT_THAT(classes(blind, task), Contains("grounding: box"));
  // Without the limit, and with the mug in view once.
  Replies fewer(boxes.begin(), boxes.begin() + 4);
  for (const char* turn : {"turn_left", "turn_left", "turn_left", "turn_left", "stop"}) fewer.emplace_back(turn);
  EXPECT_EQ(first(classes(played(task, settings_for(Mode::M3), fewer), task)), "grounding: box");
}

TEST(FailureClasses, TellTheNeedThatWasNotMet) {
  Replies far;
  for (int i = 0; i < 2; ++i) {
    for (const char* thing : {"plate_2", "lamp_1", "laptop_1", "mug_3", "apple_2"})
      far.push_back(say("pick_up", thing));
  }
  const auto found = classes("(exists (?x - Mug) (at-end (held ?x)))", Replies{say("go_to", "mug_1")} + far);
  EXPECT_EQ(first(found), "precondition: too_far");
}

TEST(FailureClasses, TellWhatOfTheGoalIsMissing) {
  const Replies stop{"stop"};
  // The order of two things.
  EXPECT_EQ(first(classes("(exists (?f - Fridge) (exists (?k - Knife) (before (open ?f) (held ?k))))",
                          {say("go_to", "knife_1"), say("pick_up", "knife_1"), say("go_to", "fridge_1"),
                           say("place_on", "fridge_1"), say("open", "fridge_1"), "stop"})),
            "goal: order_lost");
  // One of two.
  EXPECT_EQ(first(classes("(exists (?y - SideTable) (at-end (count >= 2 (?x - Mug) (on ?x ?y))))",
                          carry("mug_1", "sidetable_1") + stop)),
            "goal: count");
  // What was to stay as it is.
  EXPECT_EQ(first(classes("(exists (?f - Fridge) (and (always (closed ?f)) (exists (?m - Mug) (at-end (held ?m)))))",
                          {say("go_to", "fridge_1"), say("open", "fridge_1"), say("go_to", "mug_1"),
                           say("pick_up", "mug_1"), "stop"})),
            "goal: constraint_broken");
  // What was reached and undone on the way to the rest.
  EXPECT_EQ(first(classes("(and (exists (?f - Fridge) (at-end (open ?f))) (exists (?m - Mug) (at-end (held ?m))))",
                          {say("go_to", "fridge_1"), say("open", "fridge_1"), say("close", "fridge_1"),
                           say("go_to", "mug_1"), say("pick_up", "mug_1"), "stop"})),
            "goal: side_effect");
  // Half of it.
  EXPECT_EQ(first(classes("(and (exists (?f - Fridge) (at-end (open ?f))) (exists (?m - Mug) (at-end (held ?m))))",
                          {say("go_to", "mug_1"), say("go_to", "fridge_1"), say("open", "fridge_1"), "stop"})),
            "goal: partial");
  // Nothing.
  EXPECT_EQ(
      first(classes("(exists (?f - Fridge) (at-end (open ?f)))", {say("go_to", "fridge_1"), say("turn_left"), "stop"})),
      "goal: untouched");
}

TEST(FailureClasses, KeepAllThatFit) {
  const auto found = classes(kMugOnTable, carry("apple_1", "sidetable_1") + Replies{"stop"}, 20);
  EXPECT_THAT(found, ::testing::ElementsAre("stop: premature", "grounding: wrong_category", "goal: untouched"));
}

TEST(FailureClasses, AreReadAsTheyAreWritten) {
  EXPECT_EQ(failure_class_of("output: no_json"), (FailureClass{FailureGroup::Output, "no_json"}));
  for (const char* wrong : {"", "output", "output: ", "no: such"}) EXPECT_EQ(failure_class_of(wrong), std::nullopt);
}

}  // namespace
}  // namespace unietp
