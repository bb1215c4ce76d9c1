// The columns of a mode, each set alone: what an agent is told, what it may do, and how an episode ends.
#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "environment/agent_text.h"
#include "environment/floor_plan.h"
#include "environment/observation_json.h"
#include "expert/execution_tree.h"
#include "expert/window.h"
#include "tests/environment/house_task.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;
using ::testing::HasSubstr;
using testing::house_environment;
using ::testing::Not;
using testing::say;

Settings with(const std::string& json) {
  const auto settings = settings_from_json("test", Json::parse(json));
  EXPECT_TRUE(settings) << json << ": " << format(settings.error());
  return settings ? *settings : Settings();
}

const ActionReport& last_of(const StepResult& step) { return *step.observation.last; }

TEST(SettingsOfAMode, OfferTheActionsThatTheTableOffers) {
  for (const Mode mode : kModes) {
    int offered = 0;
    for (const auto& actions : {all_actions(), extension_actions()}) {
      for (const ActionInfo& action : actions) {
        EXPECT_EQ(offers(action, rules_of(mode)), offers(action, mode)) << action.name << " in " << name_of(mode);
        offered += offers(action, rules_of(mode)) && !is_extension(action.type);
      }
    }
    EXPECT_EQ(offered, mode == Mode::M1 ? 38 : 32);
  }
}

TEST(SettingsOfAMode, AreWrittenAndReadBack) {
  for (const Mode mode : kModes) {
    for (const Conventions conventions : kConventions) {
      const Settings settings = settings_for(mode, conventions);
      const Json json = settings_to_json(settings);
      EXPECT_EQ(json.size(), setting_names().size());
      const auto again = settings_from_json("test", json);
      ASSERT_TRUE(again) << format(again.error());
      EXPECT_EQ(*again, settings);
      EXPECT_EQ(with(R"({"mode": ")" + std::string(name_of(mode)) + R"(", "conventions": ")" +
                     std::string(name_of(conventions)) + "\"}"),
                settings);
    }
  }
}

TEST(SettingsOfAMode, RefuseWhatTheyDoNotKnow) {
  for (const auto& [json, expected] : std::vector<std::pair<std::string, std::string>>{
           {R"({"teleprot": "rooms"})", "teleport"},
           {R"({"teleport": "everywhere"})", "nothing, rooms, furniture, anything"},
           {R"({"picture": 1})", "true or false"},
           {R"({"steps": 0})", "1 to"},
           {R"({"steps": -4})", "whole number"},
           {R"({"steps": 1.5})", "whole number"},
           {R"({"steps": 99999999999999999999})", "whole number"},
           {R"({"image_width": 3})", "pixels"},
           {R"({"mode": "M4"})", "M1, M2, M3"},
           {R"({"feedback": "none", "invalid": "free"})", "counts"},
           {R"({"feedback": "none", "on_fail": "stop"})", "continue"},
           {R"({"global": "by_room", "rooms": false})", "list"},
           {R"([1])", "object"}}) {
    const auto settings = settings_from_json("test", Json::parse(json));
    ASSERT_FALSE(settings) << json;
    EXPECT_EQ(settings.error().kind, Error::Kind::Usage);
    EXPECT_THAT(format(settings.error()), HasSubstr(expected)) << json;
  }
}

TEST(WhatAnAgentIsTold, FollowsEachColumnAlone) {
  const Json all = observation_to_json(house_environment(with("{}")).observe(), with("{}"));
  for (const auto& [column, field] : std::vector<std::pair<std::string, std::string>>{{"picture", "image"},
                                                                                      {"boxes", "boxes"},
                                                                                      {"rooms", "rooms"},
                                                                                      {"furniture", "furniture"},
                                                                                      {"movables", "movables"}}) {
    const Settings settings = with("{\"" + column + "\": false}");
    const Json without = observation_to_json(house_environment(settings).observe(), settings);
    EXPECT_TRUE(all.contains(field)) << field;
    EXPECT_FALSE(without.contains(field)) << field;
    EXPECT_EQ(without.size(), all.size() - 1) << "and nothing else changes";
  }
}

ToldFloorPlan sorted(ToldFloorPlan plan) {
  const auto by_id = [](const auto& a, const auto& b) { return a.id < b.id; };
  std::sort(plan.rooms.begin(), plan.rooms.end(), by_id);
  std::sort(plan.furniture.begin(), plan.furniture.end(), by_id);
  return plan;
}

TEST(WhatAnAgentIsTold, OnTheFloorPlanIsWhatTheExpertOfItsModeKnows) {
  for (const Mode mode : {Mode::M2, Mode::M3}) {
    const Settings settings = settings_for(mode);
    const Environment environment = house_environment(settings);
    const EnvironmentTask& task = *environment.task();
    auto executions = *ExecutionTree::of(task.goal, task.start, *task.data.knowledge, *task.data.profile);
    const EpisodeWindow window(executions, mode);
    const ToldFloorPlan told = *environment.observe().home->floor_plan;
    EXPECT_EQ(sorted(told), sorted(floor_plan_of(window.known_scene(), settings.rules)));
    EXPECT_EQ(told.rooms.size(), 2U);
    EXPECT_EQ(told.doors.size(), 1U);
    EXPECT_EQ(told.furniture.empty(), mode == Mode::M3);
    EXPECT_EQ(environment.observe().pose, own_pose(window.body()));
    EXPECT_THAT(environment.prompt(false), HasSubstr("kitchen_1 (0, 0) (5, 0) (5, 4) (0, 4)"));
    EXPECT_THAT(environment.text(), HasSubstr("You stand at (1.5, 2.3), facing 0 degrees."));
    const std::string dresser = "dresser_1 (0.35, 1.8, 0.35) 0.8 x 0.45 x 0.7, 90";
    EXPECT_EQ(environment.prompt(false).find(dresser) != std::string::npos, mode == Mode::M2);
  }
}

TEST(WhatAnAgentIsTold, HasNoFloorPlanInM1NorByTheConventionsOfTheReleaseNorWhereItIsNotWanted) {
  for (const char* json :
       {R"({"mode": "M1"})", R"({"mode": "M2", "conventions": "release"})", R"({"mode": "M3", "floor_plan": false})"}) {
    const Settings settings = with(json);
    const Environment environment = house_environment(settings);
    const Json told = observation_to_json(environment.observe(), settings);
    EXPECT_FALSE(told.contains("floor_plan") || told.contains("pose")) << json;
    EXPECT_THAT(environment.prompt(false), Not(HasSubstr("corners"))) << json;
    EXPECT_THAT(environment.text(), Not(HasSubstr("You stand"))) << json;
  }
}

TEST(WhatAnAgentIsTold, ComesByRoomOnRequest) {
  const Environment environment = house_environment(with(R"({"global": "by_room"})"));
  const HomeInformation& home = *environment.observe().home;
  ASSERT_EQ(home.by_room.size(), 2U);
  std::size_t furniture = 0, movables = 0;
  for (const RoomContents& room : home.by_room) {
    for (const NamedEntity& thing : room.furniture)
      EXPECT_TRUE(has_edge(environment.scene(), Predicate::InRoom, thing.id, room.room.id)) << thing.id;
    furniture += room.furniture.size();
    movables += room.movables.size();
  }
  EXPECT_EQ(furniture, home.furniture.size());
  EXPECT_EQ(movables, home.movables.size());

  // The prompt tells the same.
  const std::string prompt = environment.prompt() + "\n";  // it ends without one
  for (const RoomContents& room : home.by_room) {
    std::string line = room.room.id + ":";
    for (const auto* things : {&room.furniture, &room.movables}) {
      for (const auto& thing : *things) line += " " + thing.id + ",";
    }
    line.back() = '.';
    EXPECT_THAT(prompt, HasSubstr("\n" + line + "\n"));
  }
  EXPECT_THAT(prompt, Not(HasSubstr("Furniture:")));
}

TEST(WhatAnAgentMayDo, TeleportsAsFarAsTheColumnSays) {
  const auto failure_of = [](const char* teleport, const char* id) {
    Environment environment =
        house_environment(with(R"({"boxes": false, "reach": "none", "teleport": ")" + std::string(teleport) + "\"}"));
    return last_of(environment.step(say("go_to", id))).failure;
  };
  EXPECT_EQ(failure_of("anything", "mug_1"), Failure::None);
  EXPECT_EQ(failure_of("furniture", "mug_1"), Failure::NotInView);
  EXPECT_EQ(failure_of("furniture", "fridge_1"), Failure::None);
  EXPECT_EQ(failure_of("rooms", "fridge_1"), Failure::InvalidArgument);
  EXPECT_EQ(failure_of("rooms", "kitchen_1"), Failure::None);
  EXPECT_EQ(failure_of("nothing", "kitchen_1"), Failure::NotOffered);
}

TEST(WhatAnAgentMayDo, ReachesMovesAndHandlesAsTheColumnsSay) {
  const auto failure_of = [](const std::string& settings, const std::string& said) {
    Environment environment = house_environment(with(settings));
    return last_of(environment.step(said)).failure;
  };
  EXPECT_EQ(failure_of(R"({"reach": "none"})", say("turn_to", "fridge_1")), Failure::NotOffered);
  EXPECT_EQ(failure_of(R"({"move": false})", say("turn_left")), Failure::NotOffered);
  EXPECT_EQ(failure_of("{}", say("turn_left")), Failure::None);
  EXPECT_EQ(failure_of(R"({"atomic": "none"})", say("open", "fridge_1")), Failure::NotOffered);
  EXPECT_EQ(failure_of(R"({"atomic": "box"})", say("open", "fridge_1")), Failure::InvalidArgument);
  EXPECT_EQ(failure_of(R"({"composite": "none"})", say("heat_with", "microwave_1")), Failure::NotOffered);
  EXPECT_EQ(failure_of("{}", say("heat_with", "microwave_1")), Failure::NotHolding);
  EXPECT_EQ(failure_of(R"({"mode": "M3", "composite": "box"})", say("heat_with", "microwave_1")),
            Failure::InvalidArgument);
}

TEST(WhatAnAgentMayDo, KnowsNoIdThatNoColumnTold) {
  Environment environment = house_environment(with(R"({"movables": false, "boxes": false})"));
  EXPECT_EQ(last_of(environment.step(say("pick_up", "mug_1"))).failure, Failure::NotSeenYet);
  EXPECT_EQ(last_of(environment.step(say("go_to", "mug_1"))).failure, Failure::NotInView);
}

TEST(AnEpisodeUnderSettings, EndsAtItsOwnLimits) {
  Environment few = house_environment(with(R"({"steps": 3})"));
  EXPECT_FALSE(few.step(say("turn_left")).truncated);
  EXPECT_FALSE(few.step(say("turn_left")).truncated);
  const StepResult last = few.step(say("turn_left"));
  EXPECT_TRUE(last.truncated);
  EXPECT_FALSE(last.terminated);
  EXPECT_EQ(few.privileged().ended_by, "steps");
  Environment clumsy = house_environment(with(R"({"failures": 2})"));
  EXPECT_FALSE(clumsy.step("nonsense").terminated);
  EXPECT_TRUE(clumsy.step(say("fly")).terminated);
  EXPECT_EQ(clumsy.privileged().ended_by, "failures");
}

TEST(AnEpisodeUnderSettings, TakesInvalidActionsForNothingWhereTheyAreFree) {
  Environment free = house_environment(with(R"({"invalid": "free", "steps": 3})"));
  for (const std::string& said : {std::string("nonsense"), say("fly"), say("pick_up"), say("pick_up", "unicorn_1")}) {
    const StepResult step = free.step(said);
    EXPECT_EQ(step.observation.step, 0) << said;
    EXPECT_FALSE(step.executed.front().counted);
    EXPECT_FALSE(*last_of(step).success);
  }
  EXPECT_EQ(free.step(say("pick_up", "mug_1")).observation.step, 1) << "a valid action that fails counts";
  EXPECT_TRUE(free.step("nonsense").truncated) << "twice the steps are as many answers as there can be";
  EXPECT_EQ(free.privileged().ended_by, "answers");
}

TEST(AnEpisodeUnderSettings, GoesOnInAListAfterAFailureOrStops) {
  const std::string list = "[" + say("turn_left") + "," + say("fly") + "," + say("turn_left") + "]";
  Environment on = house_environment(with("{}")), stops = house_environment(with(R"({"on_fail": "stop"})"));
  EXPECT_EQ(on.step(list).observation.results.size(), 3U);
  EXPECT_EQ(on.observe().step, 3);
  EXPECT_EQ(stops.step(list).observation.results.size(), 2U);
  EXPECT_EQ(stops.observe().step, 2);
}

TEST(AnEpisodeUnderSettings, GivesAwayNoSuccessWithoutFeedback) {
  for (const char* mode : {"M1", "M2", "M3"}) {
    const Settings settings = with(R"({"feedback": "none", "mode": ")" + std::string(mode) + "\"}");
    Environment environment = house_environment(settings);
    Environment other = environment.clone();
    const StepResult good = environment.step(say("turn_left")), bad = other.step(say("fly"));
    EXPECT_TRUE(good.executed.front().outcome.success);
    EXPECT_FALSE(bad.executed.front().outcome.success);
    Json told_good = observation_to_json(good.observation, settings);
    Json told_bad = observation_to_json(bad.observation, settings);
    for (Json* told : {&told_good, &told_bad}) {
      EXPECT_FALSE(told->contains("held") || told->contains("failures_left")) << told->dump();
      EXPECT_EQ((*told)["last"].size(), 1U) << "the action alone";
      told->erase("boxes");  // which turn with the camera
    }
    EXPECT_EQ(told_good.dump(), told_bad.dump());
    EXPECT_THAT(other.text(), Not(HasSubstr("failed")));
    EXPECT_THAT(environment.text(), Not(HasSubstr("succeeded")));
  }
}

TEST(AnEpisodeUnderSettings, TellsSuccessAloneOnRequest) {
  const Settings settings = with(R"({"feedback": "success"})");
  Environment environment = house_environment(settings);
  const Observation seen = environment.step(say("pick_up", "mug_1")).observation;
  EXPECT_FALSE(*seen.last->success);
  EXPECT_EQ(seen.last->failure, Failure::None);
  EXPECT_EQ(seen.last->feedback, "");
  EXPECT_TRUE(seen.held && seen.failures_left);
  EXPECT_THAT(environment.text(), HasSubstr("The last action failed."));
}

TEST(AnEpisodeUnderSettings, HasPicturesAndBoxesInTheSizeThatWasAskedFor) {
  Environment environment = house_environment(with(R"({"image_width": 300, "image_height": 200})"));
  (void)environment.step(say("go_to", "fridge_1"));
  const Picture picture = environment.picture();
  EXPECT_EQ(picture.width, 300);
  EXPECT_EQ(picture.height, 200);
  EXPECT_EQ(picture.rgb.size(), 300U * 200 * 3);
  ASSERT_FALSE(environment.observe().boxes->empty());
  for (const ObservedObject& object : *environment.observe().boxes) {
    EXPECT_LT(object.box[2], 300);
    EXPECT_LT(object.box[3], 200);
  }
  EXPECT_EQ(environment.render(64, 48)->width, 64);
  EXPECT_FALSE(environment.render(64, 1 << 20));
  EXPECT_FALSE(environment.channels(8, 64));
}

TEST(AnEpisodeUnderSettings, HasDepthNormalsAndObjectsOfEveryViewpointsPicture) {
  Environment environment = house_environment(settings_for(Mode::M1));
  (void)environment.step(say("go_to", "fridge_1"));
  const auto agent = static_cast<std::int32_t>(environment.scene().nodes.size());
  std::set<std::vector<std::uint8_t>> pictures;
  for (const Viewpoint viewpoint : kViewpoints) {
    const auto channels = environment.channels(64, 48, viewpoint);
    ASSERT_TRUE(channels);
    EXPECT_EQ(channels->depth.size(), 64U * 48);
    EXPECT_EQ(channels->normal.size(), 3U * 64 * 48);
    const auto last = *std::max_element(channels->node.begin(), channels->node.end());
    EXPECT_EQ(last == agent, viewpoint != Viewpoint::Agent) << name_of(viewpoint);
    EXPECT_LE(last, agent);
    pictures.insert(environment.render(64, 48, viewpoint)->rgb);
  }
  EXPECT_EQ(pictures.size(), 3U);
}

TEST(AnEpisodeUnderSettings, TellsBoxesInTheFormInWhichItReadsThem) {
  for (const char* form : {"pixels", "unit", "thousand", "thousand_y_first"}) {
    SCOPED_TRACE(form);
    const Settings settings = with(R"({"mode": "M3", "boxes": true, "box_form": ")" + std::string(form) + "\"}");
    Environment environment = house_environment(settings);
    (void)environment.step(say("go_to", "kitchen_1"));
    for (int i = 0; i < 12 && environment.observe().boxes->empty(); ++i) (void)environment.step(say("turn_left"));
    const Json told = observation_to_json(environment.observe(), settings);
    ASSERT_FALSE(told["boxes"].empty());
    for (std::size_t i = 0; i < told["boxes"].size(); ++i) {
      const std::string said = Json{{"action", "turn_to"}, {"args", {{{"bbox", told["boxes"][i]["box"]}}}}}.dump();
      const auto answer = parse_answer(
          said, {settings.box_form, environment.observe().image_width, environment.observe().image_height});
      ASSERT_TRUE(answer);
      EXPECT_EQ(*answer->actions.front().command.args.front().box, (*environment.observe().boxes)[i].box);
    }
  }
}

}  // namespace
}  // namespace unietp
