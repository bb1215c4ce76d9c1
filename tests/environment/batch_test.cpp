// Environments stepped together: as single ones, for any number of threads, with autoreset on the next step.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "environment/batch.h"
#include "environment/observation_json.h"
#include "tests/environment/house_task.h"
#include "tests/environment/random_agent.h"

namespace unietp {
namespace {

using testing::house_task;
using testing::RandomAgent;

const std::vector<std::string> kGoals{"(exists (?x - Mug) (at-end (held ?x)))",
                                      "(exists (?f - Fridge) (at-end (open ?f)))"};

Result<SharedTask> task_of(std::size_t environment, std::uint64_t episode) {
  return house_task(kGoals[(environment + episode) % kGoals.size()]);
}

Settings short_episodes() {
  Settings settings = settings_for(Mode::M2);
  settings.rules.limits.steps = 7;
  return settings;
}

std::string text_of(const StepResult& step) { return step_to_json(step, short_episodes()).dump(); }

/// What each environment tells, and what was said to it, over some steps.
struct Log {
  std::vector<std::vector<std::string>> observations, said;
};
Log run(int threads) {
  auto batch = EnvironmentBatch::make(5, threads, short_episodes(), task_of);
  EXPECT_TRUE(batch);
  std::vector<RandomAgent> agents;
  for (std::uint64_t i = 0; i < batch->size(); ++i) agents.emplace_back(Rng(1).fork("agent", i));
  Log log{std::vector<std::vector<std::string>>(5), std::vector<std::vector<std::string>>(5)};
  for (int step = 0; step < 40; ++step) {
    std::vector<std::string> said;
    for (std::size_t i = 0; i < batch->size(); ++i) said.push_back(agents[i].answer(batch->at(i)));
    const auto results = batch->step(said);
    EXPECT_TRUE(results);
    for (std::size_t i = 0; i < batch->size(); ++i) {
      log.observations[i].push_back(text_of((*results)[i]));
      log.said[i].push_back(said[i]);
    }
  }
  return log;
}

TEST(ABatch, GivesTheSameForAnyNumberOfThreadsAsSingleEnvironmentsDo) {
  const Log one = run(1), several = run(3);
  EXPECT_EQ(one.observations, several.observations);
  for (std::size_t i = 0; i < one.said.size(); ++i) {
    SCOPED_TRACE(i);
    std::uint64_t episode = 0;
    Environment alone = std::move(*Environment::make(*task_of(i, episode), short_episodes()));
    for (std::size_t step = 0; step < one.said[i].size(); ++step) {
      if (alone.over()) {
        ASSERT_TRUE(alone.reset(*task_of(i, ++episode)));
        StepResult first;
        first.observation = alone.observe();
        ASSERT_EQ(one.observations[i][step], text_of(first)) << "the next step begins the next episode";
        continue;
      }
      ASSERT_EQ(one.observations[i][step], text_of(alone.step(one.said[i][step])));
    }
    EXPECT_GT(episode, 3U);
  }
}

TEST(ABatch, RefusesAWrongNumberOfAnswersAndTasksThatCannotBe) {
  auto batch = EnvironmentBatch::make(2, 1, short_episodes(), task_of);
  ASSERT_TRUE(batch);
  EXPECT_FALSE(batch->step(std::vector<std::string>{"stop"}));
  EXPECT_FALSE(EnvironmentBatch::make(0, 1, short_episodes(), task_of));
  const auto none = [](std::size_t, std::uint64_t) {
    return Result<SharedTask>(Error{Error::Kind::Usage, "", {}, "none"});
  };
  EXPECT_EQ(EnvironmentBatch::make(2, 2, short_episodes(), none).error().message, "none");
}

TEST(ABatch, MakesPicturesAsSingleEnvironmentsDo) {
  auto batch = EnvironmentBatch::make(3, 2, short_episodes(), task_of);
  ASSERT_TRUE(batch);
  ASSERT_TRUE(batch->step(std::vector<std::string>(3, "turn_left")));
  const auto pictures = batch->pictures();
  for (std::size_t i = 0; i < pictures.size(); ++i) EXPECT_EQ(pictures[i].rgb, batch->at(i).picture().rgb);
}

}  // namespace
}  // namespace unietp
