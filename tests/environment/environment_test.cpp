// Episodes: what they end in, what they remember, and that equal actions give equal observations.
#include <malloc.h>
#include <algorithm>

#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "environment/observation_json.h"
#include "expert/mode_expert.h"
#include "logic/evaluate.h"
#include "scene/trace.h"
#include "simulation/mode_episode.h"
#include "tests/environment/house_task.h"
#include "tests/environment/random_agent.h"
#include "tests/expert/house.h"

namespace unietp {
namespace {

using ::testing::HasSubstr;
using testing::house_environment;
using testing::house_task;
using testing::RandomAgent;
using testing::say;

std::string shown_to_agent(const Environment& environment) {
  return observation_to_json(environment.observe(), environment.settings()).dump() + environment.text();
}

/// What the expert does for a task in a mode.
std::vector<Command> expert_commands(const EnvironmentTask& task, Mode mode) {
  const auto first = demonstrate(task.goal, task.start, *task.data.knowledge, *task.data.profile, {});
  auto shown = std::get<Demonstration>(first);
  if (mode != Mode::M1)
    shown = std::get<Demonstration>(
        demonstrate_in(mode, task.goal, task.start, *task.data.knowledge, *task.data.profile, shown));
  std::vector<Command> commands;
  for (const DemonstrationStep& step : shown.steps) commands.push_back(step.command);
  return commands;
}

TEST(AnEnvironment, RewardsTheExpertInEveryModeAndNobodyWhoStopsAtOnce) {
  for (const Mode mode : kModes) {
    SCOPED_TRACE(name_of(mode));
    Environment environment = house_environment(settings_for(mode));
    StepResult last;
    double sum = 0;
    for (const Command& command : expert_commands(*environment.task(), mode)) {
      EXPECT_FALSE(last.terminated);
      last = environment.step(command);
      EXPECT_TRUE(last.executed.front().outcome.success) << last.executed.front().outcome.feedback;
      sum += last.reward;
    }
    EXPECT_TRUE(last.terminated && !last.truncated && environment.over());
    EXPECT_EQ(sum, 1);
    EXPECT_EQ(last.reward, 1) << "at the end, not before";
    EXPECT_TRUE(environment.privileged().success);
    EXPECT_EQ(environment.privileged().ended_by, "stop");

    environment.reset();
    const StepResult idle = environment.step("stop");
    EXPECT_TRUE(idle.terminated);
    EXPECT_EQ(idle.reward, 0);
  }
}

TEST(AnEnvironment, RewardsProgressOnRequestSoThatItAddsUp) {
  Settings settings = settings_for(Mode::M1);
  settings.reward = Reward::Progress;
  Environment environment = house_environment(
      settings, "(and (exists (?x - Mug) (at-end (held ?x))) (exists (?f - Fridge) (at-end (open ?f))))");
  const double before = environment.privileged().progress;
  double sum = 0;
  for (const Command& command : expert_commands(*environment.task(), Mode::M1)) sum += environment.step(command).reward;
  EXPECT_DOUBLE_EQ(before + sum, 1);
  environment.reset();
  (void)environment.step(say("go_to", "fridge_1"));
  EXPECT_GT(environment.step(say("open", "fridge_1")).reward, 0);
  EXPECT_LT(environment.step(say("close", "fridge_1")).reward, 0);
}

TEST(AnEnvironment, DoesNothingAfterTheEnd) {
  Environment environment = house_environment(settings_for(Mode::M1));
  (void)environment.step("stop");
  const std::string before = shown_to_agent(environment);
  const StepResult again = environment.step(say("turn_left"));
  EXPECT_EQ(again.reward, 0);
  EXPECT_TRUE(again.terminated && again.executed.empty());
  EXPECT_EQ(shown_to_agent(environment), before);
}

TEST(AnEnvironment, IsTheSameAgainAfterAReset) {
  Environment environment = house_environment(settings_for(Mode::M2));
  std::vector<std::string> said, first;
  RandomAgent agent{Rng(4)};
  for (int i = 0; i < 30 && !environment.over(); ++i) {
    said.push_back(agent.answer(environment));
    (void)environment.step(said.back());
    first.push_back(shown_to_agent(environment));
  }
  const std::string start = shown_to_agent(house_environment(settings_for(Mode::M2)));
  environment.reset();
  EXPECT_EQ(shown_to_agent(environment), start);
  for (std::size_t i = 0; i < said.size(); ++i) {
    (void)environment.step(said[i]);
    ASSERT_EQ(shown_to_agent(environment), first[i]) << said[i];
  }
}

TEST(AnEnvironment, IsLeftAloneByItsClonesAndComesBackToItsSnapshots) {
  for (const Mode mode : kModes) {
    Environment environment = house_environment(settings_for(mode));
    RandomAgent agent{Rng(9)};
    for (int i = 0; i < 8; ++i) (void)environment.step(agent.answer(environment));
    const Environment::Snapshot snapshot = environment.snapshot();
    const std::string here = shown_to_agent(environment);
    const Scene scene = environment.scene();

    Environment clone = environment.clone();
    std::vector<std::string> said;
    for (int i = 0; i < 8 && !clone.over(); ++i) {
      said.push_back(agent.answer(clone));
      (void)clone.step(said.back());
    }
    EXPECT_EQ(shown_to_agent(environment), here);
    EXPECT_TRUE(environment.scene() == scene);
    for (const std::string& one : said) (void)environment.step(one);
    EXPECT_EQ(shown_to_agent(environment), shown_to_agent(clone)) << "both went the same way";
    EXPECT_TRUE(environment.scene() == clone.scene());
    environment.restore(snapshot);
    EXPECT_EQ(shown_to_agent(environment), here);
    EXPECT_TRUE(environment.scene() == scene);
    for (const std::string& one : said) (void)environment.step(one);
    EXPECT_EQ(shown_to_agent(environment), shown_to_agent(clone)) << "and again after going back";
  }
}

TEST(AnEnvironment, JudgesTheGoalAtEachStepAsTheEvaluatorDoes) {
  const std::vector<std::string> goals{"(exists (?x - Mug) (at-end (held ?x)))",
                                       "(exists (?f - Fridge) (and (sometime (open ?f)) (at-end (not (open ?f)))))",
                                       "(exists (?f - Fridge) (exists (?x - Mug) (before (open ?f) (held ?x))))",
                                       "(forall (?x - Mug) (always (not (held ?x))))",
                                       "(count >= 2 (?x - (either Mug Apple)) (sometime (held ?x)))"};
  int satisfied = 0;
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    SCOPED_TRACE(seed);
    Settings settings = settings_for(kModes[seed % 3]);
    settings.rules.limits = {60, 60};
    Environment environment = house_environment(settings, goals[seed % goals.size()]);
    const EnvironmentTask& task = *environment.task();
    RandomAgent agent(Rng(7).fork("agent", seed));
    std::vector<Delta> changes;
    while (!environment.over()) {
      for (const ExecutedAction& one : environment.step(agent.answer(environment)).executed)
        changes.push_back(one.changes);
      const bool holds_now = holds(task.goal, to_logic(task.start, changes, reads_comparisons(task.goal)));
      ASSERT_EQ(environment.privileged().success, holds_now);
      ASSERT_EQ(environment.privileged().progress == 1, holds_now);
      satisfied += holds_now;
    }
  }
  EXPECT_GT(satisfied, 100) << "and not because it never holds";
}

TEST(AnEnvironment, ForgetsWithoutAnyDifference) {
  for (const Mode mode : kModes) {
    Settings settings = settings_for(mode);
    settings.rules.limits = {200, 200};
    Environment environment = house_environment(settings);
    const EnvironmentTask& task = *environment.task();
    ModeEpisode remembers(*World::create(task.start, *task.data.knowledge, *task.data.profile), settings.rules);
    RandomAgent agent{Rng(3)};
    while (!environment.over()) {
      for (const ExecutedAction& one : environment.step(agent.answer(environment)).executed) {
        if (one.command.action.empty()) {
          (void)remembers.refuse("");
          continue;
        }
        const auto before = remembers.world().moment();
        const Outcome outcome = remembers.step(one.command);
        EXPECT_EQ(one.outcome.success, outcome.success) << to_text(one.command);
        EXPECT_EQ(one.outcome.feedback, outcome.feedback) << to_text(one.command);
        EXPECT_EQ(one.changes, remembers.world().moment() == before ? Delta() : remembers.world().changes());
      }
      ASSERT_TRUE(environment.scene() == remembers.world().scene());
      EXPECT_EQ(environment.pictured(), remembers.world().pictured());
      std::vector<std::string> pictured, asked_for;
      for (const VisibleObject& object : environment.pictured()) pictured.push_back(object.id);
      for (const Node& node : environment.scene().nodes) {
        EXPECT_TRUE(environment.has_object(node.id));
        if (environment.pictures(node.id)) asked_for.push_back(node.id);
      }
      std::sort(asked_for.begin(), asked_for.end());
      EXPECT_EQ(asked_for, pictured);
      EXPECT_FALSE(environment.has_object("no such thing") || environment.pictures("no such thing"));
      EXPECT_EQ(environment.privileged().failures, remembers.failures());
    }
  }
}

TEST(AnEnvironment, TakesNoMoreMemoryHoweverLongAnEpisodeIs) {
  if (mallinfo2().uordblks == 0) GTEST_SKIP() << "needs the C library's own allocator";
  Settings settings = settings_for(Mode::M2);
  const char* longer = std::getenv("UNIETP_LONG");
  const int steps = longer == nullptr ? 3000 : 100'000;
  settings.rules.limits = {10 * steps, 10 * steps};
  Environment environment = house_environment(settings);
  RandomAgent agent{Rng(11)};
  const auto go_on = [&](int count) {
    for (int i = 0; i < count; ++i) (void)environment.step(agent.answer(environment));
    return mallinfo2().uordblks;
  };
  const auto early = go_on(steps / 2), late = go_on(steps / 2);
  EXPECT_FALSE(environment.over());
  constexpr std::size_t kSlack = 2 << 20;
  EXPECT_LT(late, early + kSlack) << steps << " steps";
}

TEST(AnEnvironment, TakesNoMoreMemoryHoweverOftenItIsReset) {
  if (mallinfo2().uordblks == 0) GTEST_SKIP() << "needs the C library's own allocator";
  const int resets = std::getenv("UNIETP_LONG") == nullptr ? 1000 : 100'000;
  Environment environment = house_environment(settings_for(Mode::M1));
  const auto go_on = [&](int count) {
    for (int i = 0; i < count; ++i) {
      environment.reset();
      (void)environment.step(say("go_to", "mug_1"));
    }
    return mallinfo2().uordblks;
  };
  const auto early = go_on(resets / 2), late = go_on(resets / 2);
  constexpr std::size_t kSlack = 1 << 20;
  EXPECT_LT(late, early + kSlack);
}

TEST(AnEnvironment, AnswersAlikeInM2ForWhatDoesNotExistAndWhatWasNotSeen) {
  Environment environment = house_environment(settings_for(Mode::M2));
  std::string unseen;
  for (const Node& node : environment.scene().nodes) {
    const auto& boxes = *environment.observe().boxes;
    const bool seen = std::any_of(boxes.begin(), boxes.end(), [&](const auto& one) { return one.id == node.id; });
    if (node.movable && !seen) unseen = node.id;
  }
  ASSERT_FALSE(unseen.empty());
  const std::string nothing = "unicorn_1";
  for (const ActionInfo& action : all_actions()) {
    SCOPED_TRACE(action.name);
    Environment a = environment.clone(), b = environment.clone();
    const StepResult of_unseen = a.step(say(std::string(action.name), unseen));
    const StepResult of_nothing = b.step(say(std::string(action.name), nothing));
    const auto shown_about = [](const Environment& one, std::string text, const std::string& id) {
      for (auto at = text.find(id); at != std::string::npos; at = text.find(id)) text.replace(at, id.size(), "it");
      return text + std::to_string(one.privileged().failures);
    };
    EXPECT_EQ(shown_about(a, shown_to_agent(a), unseen), shown_about(b, shown_to_agent(b), nothing));
    EXPECT_EQ(of_unseen.executed.front().outcome.feedback, of_nothing.executed.front().outcome.feedback);
    EXPECT_FALSE(of_unseen.executed.front().outcome.success);
  }
}

TEST(AnEnvironment, RepeatsNoIdToAnAgentInM3ThatGuessesOne) {
  for (const std::string& said :
       {say("pick_up", "mug_1"), say("go_to", "fridge_1"), say("mug_1", "mug_1"), say("turn_left", "mug_1"),
        std::string("mug_1"), std::string(R"({"action": "mug_1"})")}) {
    Environment environment = house_environment(settings_for(Mode::M3));
    const StepResult step = environment.step(said);
    const std::string all = shown_to_agent(environment) + step.executed.front().outcome.feedback;
    EXPECT_EQ(all.find("mug_1"), std::string::npos) << all;
    EXPECT_EQ(all.find("fridge_1"), std::string::npos) << all;
    EXPECT_FALSE(*step.observation.last->success);
  }
}

TEST(AnEnvironment, TakesAPointForWhatThePictureShowsThere) {
  Environment environment = house_environment(settings_for(Mode::M3));
  (void)environment.step(say("go_to", "kitchen_1"));
  for (int i = 0; i < 12 && environment.pictured().empty(); ++i) (void)environment.step(say("turn_left"));
  Rays rays;
  const Segmentation image = segmentation_of(environment.scene(), *environment.task()->data.profile, rays);
  int tried = 0;
  for (std::size_t at = 0; at < image.node.size(); at += 997) {
    Environment one = environment.clone();
    const int x = static_cast<int>(at) % image.width, y = static_cast<int>(at) / image.width;
    const StepResult step = one.step(R"({"action": "turn_to", "args": [{"point": [)" + std::to_string(x) + ", " +
                                     std::to_string(y) + "]}]}");
    if (image.node[at] < 0) {
      EXPECT_EQ(step.executed.front().outcome.failure, Failure::NoObjectThere);
      continue;
    }
    EXPECT_NE(step.executed.front().outcome.failure, Failure::NoObjectThere) << x << ", " << y;
    ++tried;
  }
  EXPECT_GT(tried, 10);
}

TEST(AnEnvironment, TellsHowManyActionsTheExpertWouldStillTake) {
  Environment environment = house_environment(settings_for(Mode::M1));
  const auto commands = expert_commands(*environment.task(), Mode::M1);
  EXPECT_EQ(environment.expert_steps_left(), static_cast<int>(commands.size()));
  for (std::size_t i = 0; i + 1 < commands.size(); ++i) {
    (void)environment.step(commands[i]);
    const auto left = environment.expert_steps_left();
    ASSERT_TRUE(left);
    EXPECT_LE(*left, static_cast<int>(commands.size() - i));
  }
  EXPECT_EQ(environment.expert_steps_left(), 1) << "stop";
  (void)environment.step("stop");
  EXPECT_EQ(environment.expert_steps_left(), std::nullopt);
}

TEST(AnEnvironment, TellsItsAgentWhatTheExportTeaches) {
  Environment environment = house_environment(settings_for(Mode::M1));
  EXPECT_THAT(environment.text(), ::testing::StartsWith("Task: Put a mug on the side table.\n"));
  (void)environment.step(say("go_to", "mug_1"));
  EXPECT_THAT(environment.text(), ::testing::StartsWith("The last action succeeded.\nIn view: "));
  (void)environment.step(say("open", "mug_1"));
  EXPECT_THAT(environment.text(), HasSubstr("The last action failed. mug_1 cannot be opened or closed.\n"));
  EXPECT_THAT(environment.prompt(), HasSubstr("You may go to any of them.\n"));
}

TEST(TheJudgeOfAnEpisode, SeesEachMomentOfACompositeAction) {
  const auto cooled = [](const std::string& goal) {
    Environment environment = house_environment(settings_for(Mode::M1), goal);
    StepResult last;
    for (const auto& [action, id] :
         {std::pair{"go_to", "potato_1"}, {"pick_up", "potato_1"}, {"go_to", "fridge_1"}, {"cool_with", "fridge_1"}}) {
      last = environment.step(say(action, id));
      EXPECT_TRUE(last.executed.front().outcome.success) << action;
      EXPECT_EQ(last.executed.front().moments.empty(), std::string(action) != "cool_with");
    }
    return environment.privileged();
  };
  const PrivilegedState kept = cooled("(exists (?f - Fridge) (always (closed ?f)))");
  EXPECT_FALSE(kept.success);
  EXPECT_TRUE(kept.hopeless);
  EXPECT_TRUE(cooled("(exists (?f - Fridge) (sometime (open ?f)))").success);
  EXPECT_TRUE(cooled("(exists (?f - Fridge) (and (at-end (closed ?f)) (sometime (open ?f))))").success);
  // Comparisons are read from the scene as it is at each moment.
  EXPECT_TRUE(
      cooled("(exists (?f - Fridge) (exists (?p - Potato) (sometime (and (nearest ?p ?f) (inside ?p ?f)))))").success);
}

}  // namespace
}  // namespace unietp
