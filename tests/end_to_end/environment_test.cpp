// Environments on a real data set: demonstrations replayed in every mode, plans that must fail, agents without a plan,
// and what their modes must not tell them. On the folder in UNIETP_DATASET where it is set, with as many episodes as
// UNIETP_EPISODES says.
#include <cstdlib>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "core/text.h"
#include "data_set.h"
#include "environment/observation_json.h"
#include "logic/evaluate.h"
#include "program.h"
#include "scene/trace.h"
#include "schema_checker.h"
#include "task_sources.h"
#include "tests/environment/random_agent.h"
#include "tests/support/scratch_folder.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;
using testing::RandomAgent;

std::size_t episodes(std::size_t usually) {
  const char* given = std::getenv("UNIETP_EPISODES");
  return given == nullptr ? usually : std::strtoul(given, nullptr, 10);
}

TEST(EnvironmentsOfADataSet, GiveForEachDemonstrationWhatItsFileSays) {
  const TaskSource tasks = source();
  ASSERT_GT(tasks.size(), 0U);
  SchemaChecker checker;
  std::size_t replayed = 0;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    for (const Mode mode : tasks.listing()[i].modes) {
      SCOPED_TRACE(tasks.listing()[i].id + " in " + std::string(name_of(mode)));
      const auto shown = tasks.demonstration(i, mode);
      ASSERT_TRUE(shown) << format(shown.error());
      Environment environment = environment_of(tasks, i, mode);
      StepResult last;
      for (const StepRecord& step : shown->steps) {
        std::vector<VisibleObject> seen;
        if (environment.observe().boxes) {
          for (const ObservedObject& object : *environment.observe().boxes) seen.push_back({object.id, object.box});
        } else {
          seen = environment.pictured();
        }
        ASSERT_EQ(seen, step.visible);
        last = environment.step(command_to_json(step.command).dump());
        ASSERT_EQ(last.executed.size(), 1U);
        const ExecutedAction& done = last.executed.front();
        ASSERT_EQ(done.outcome.success, step.success) << done.outcome.feedback;
        ASSERT_EQ(name_of(done.outcome.failure), step.failure);
        ASSERT_EQ(done.outcome.feedback, step.feedback);
        ASSERT_EQ(done.changes, step.changes);
        ASSERT_EQ(done.moments, step.moments);
        if (i % 7 != 0) continue;
        const Json told = observation_to_json(last.observation, environment.settings());
        ASSERT_EQ(checker.check(told, "observation.schema.json"), "");
      }
      EXPECT_TRUE(last.terminated);
      EXPECT_EQ(last.reward, 1);
      ++replayed;
    }
  }
  std::printf("replayed %zu demonstrations\n", replayed);
}

/// Every altered plan of the validator, as an agent would say it: the environment rewards it exactly when the validator
/// found the goal reached, which of all kinds but those of order is never.
TEST(EnvironmentsOfADataSet, RewardAlteredPlansAsTheValidatorJudgesThem) {
  const ScratchFolder folder;
  const char* given = std::getenv("UNIETP_DATASET");
  const std::string set = given == nullptr ? folder.at("set") : given;
  if (given == nullptr) {  // with tasks that ask for an order, and for one of several objects
    ASSERT_EQ(run_program({"generate", "--count", "12", "--seed", "7", "--rooms", "5", "--objects", "25", "--modes",
                           "M1,M2,M3", "--splits", "logical,instance_grounding", "--out", set, "--threads", "2"})
                  .code,
              0);
  }
  const TaskSource tasks = source(set);
  ASSERT_EQ(run_program({"validate", set, "--altered-plans", folder.at("plans.jsonl")}).code, 0);
  const auto text = read_file(folder.at("plans.jsonl"));
  ASSERT_TRUE(text);
  SchemaChecker checker;
  std::map<std::string, int> tried;
  for (const std::string& line : split(trim(*text), '\n')) {
    const Json plan = Json::parse(line);
    SCOPED_TRACE(line);
    ASSERT_EQ(checker.check(plan, "altered_plan.schema.json"), "");
    const auto position = tasks.find(plan["task"].get<std::string>());
    ASSERT_TRUE(position);
    Environment environment = environment_of(tasks, *position, *mode_named(plan["mode"].get<std::string>()));
    StepResult last;
    for (const Json& action : plan["actions"]) {
      if (!environment.over()) last = environment.step(action.dump());
    }
    const bool reaches_goal = plan["reaches_goal"].get<bool>();
    const auto change = plan["change"].get<std::string>();
    EXPECT_TRUE(environment.over());
    EXPECT_EQ(last.reward, reaches_goal ? 1 : 0);
    if (change != "swapped-parts" && change != "reversed-parts") {
      EXPECT_FALSE(reaches_goal);
    }
    ++tried[change];
  }
  for (const auto& [change, count] : tried) std::printf("%d plans of %s\n", count, change.c_str());
  for (const char* change : {"missing-step", "kept-in-hand", "swapped-parts", "distractor"})
    EXPECT_GT(tried[change], 0) << change;
}

TEST(EnvironmentsOfADataSet, RewardNoPlanThatLacksAStep) {
  const TaskSource tasks = source();
  std::size_t tried = 0;
  for (std::size_t i = 0; i < std::min(tasks.size(), episodes(tasks.size())); ++i) {
    for (const Mode mode : tasks.listing()[i].modes) {
      const auto shown = tasks.demonstration(i, mode);
      ASSERT_TRUE(shown);
      for (std::size_t left_out = 0; left_out + 1 < shown->steps.size(); ++left_out) {
        if (shown->steps[left_out].search || shown->steps[left_out].tidying) continue;  // not needed for the goal
        SCOPED_TRACE(tasks.listing()[i].id + " in " + std::string(name_of(mode)) + " without step " +
                     std::to_string(left_out + 1));
        Environment environment = environment_of(tasks, i, mode);
        StepResult last;
        for (std::size_t at = 0; at < shown->steps.size() && !environment.over(); ++at) {
          if (at != left_out) last = environment.step(shown->steps[at].command);
        }
        // Where a box means something else now, the plan is another one, which may happen to serve.
        if (mode != Mode::M3) {
          EXPECT_EQ(last.reward, 0);
        }
        EXPECT_EQ(last.reward, environment.privileged().success ? 1 : 0);
        ++tried;
      }
    }
  }
  std::printf("%zu plans without one of their steps\n", tried);
}

/// The words of a text that may be ids.
std::set<std::string> words_of(const std::string& text) {
  std::set<std::string> words;
  std::string word;
  for (const char c : text + " ") {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.') {
      word += c;
      continue;
    }
    while (!word.empty() && word.back() == '.') word.pop_back();
    if (!word.empty()) words.insert(word);
    word.clear();
  }
  return words;
}

/// What an agent could read of a step.
std::string all_told(const Environment& environment, const StepResult& step) {
  std::string text = observation_to_json(step.observation, environment.settings()).dump() + environment.text();
  for (const ExecutedAction& one : step.executed) text += " " + one.outcome.feedback;
  return text;
}

TEST(EnvironmentsOfADataSet, NeverFailAnAgentWithoutAPlanNorTellItWhatItsModeMustNot) {
  const TaskSource tasks = source();
  const std::size_t count = episodes(24);
  std::size_t steps = 0, successes = 0;
  for (std::size_t episode = 0; episode < count; ++episode) {
    const Mode mode = kModes[episode % 3];
    SCOPED_TRACE("episode " + std::to_string(episode) + " in " + std::string(name_of(mode)));
    Environment environment = environment_of(tasks, (episode / 3) % tasks.size(), mode);
    const EnvironmentTask& task = *environment.task();
    RandomAgent agent(Rng(17).fork("episode", episode));
    std::set<std::string> told;  // ids that M2 has told so far
    std::vector<Delta> changes;
    for (const std::string& word : words_of(environment.prompt())) told.insert(word);
    while (!environment.over()) {
      for (const ObservedObject& object : environment.observe().boxes.value_or(std::vector<ObservedObject>()))
        told.insert(object.id);
      const StepResult step = environment.step(agent.answer(environment));
      for (const ExecutedAction& one : step.executed) changes.push_back(one.changes);
      steps += step.executed.size();
      const bool holds_now = holds(task.goal, to_logic(task.start, changes, reads_comparisons(task.goal)));
      ASSERT_EQ(environment.privileged().success, holds_now);
      successes += holds_now;
      if (mode == Mode::M1) continue;
      for (const ObservedObject& object : step.observation.boxes.value_or(std::vector<ObservedObject>()))
        told.insert(object.id);
      const auto words = words_of(all_told(environment, step));
      for (const Node& node : environment.scene().nodes) {
        if (words.contains(node.id)) {
          ASSERT_TRUE(mode == Mode::M2 && told.contains(node.id)) << node.id;
        }
      }
    }
    if (mode != Mode::M3) continue;
    const auto words = words_of(environment.prompt());
    for (const Node& node : task.start.nodes) ASSERT_FALSE(words.contains(node.id)) << node.id;
  }
  std::printf("%zu episodes, %zu actions, the goal held after %zu answers\n", count, steps, successes);
}

TEST(EnvironmentsOfADataSet, ComeInAnOrderOfTheSeedAndByTheirIds) {
  const TaskSource tasks = source();
  auto order = tasks.order(5);
  EXPECT_EQ(order, tasks.order(5));
  EXPECT_NE(order, tasks.order(6));
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
  const std::string id = tasks.listing().back().id;
  EXPECT_EQ((*tasks.task(id))->text.id, id);
  EXPECT_EQ(*tasks.task(id), *tasks.task(tasks.size() - 1)) << "shared";
  EXPECT_EQ(tasks.task("no-such-task").error().kind, Error::Kind::Usage);
  EXPECT_EQ(tasks.task(tasks.size()).error().kind, Error::Kind::Usage);
  EXPECT_FALSE(TaskSource::open("no/such/folder", committed_simulators()));
}

}  // namespace
}  // namespace unietp
