// The program's own policies in `unietp evaluate`: the expert, and demonstrations with noise.
#include <algorithm>
#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "core/text.h"
#include "data_set.h"
#include "task_sources.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using ::testing::HasSubstr;

/// Of all splits, in homes of the usual size, each shown in M1, M2 and M3.
const fs::path& tasks_of_all_splits() {
  static const ScratchFolder kScratch;
  static const fs::path kFolder = [] {
    const auto ended = run_program(
        {"generate", "--count", "20", "--seed", "27", "--modes", "M1,M2,M3", "--out", kScratch.at("all-splits")});
    EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
    return fs::path(kScratch.at("all-splits"));
  }();
  return kFolder;
}

TEST(EvaluatePolicy, TheExpertSucceedsInAllSplitsAndModes) {
  const ScratchFolder scratch;
  const auto ended = run_program({"evaluate", tasks_of_all_splits().string(), "--policy", "expert", "--modes",
                                  "M1,M2,M3", "--out", scratch.at("run")});
  EXPECT_EQ(ended.code, 0) << ended.err;
  std::set<std::string> splits;
  int episodes = 0;
  for (const Json& episode : json_lines(scratch.path() / "run/episodes.jsonl")) {
    EXPECT_EQ(episode["success"], true) << episode["task"] << " in " << episode["mode"];
    splits.insert(episode["split"]);
    ++episodes;
  }
  EXPECT_EQ(episodes, 3 * 20);
  EXPECT_EQ(splits.size(), 5U);
}

TEST(EvaluatePolicy, WithoutAPlanOfTheExpertAnEpisodeIsErrored) {
  const ScratchFolder scratch;
  ASSERT_EQ(run_program({"generate", "--extended", "--template", "read-one", "--simulators", "virtualhome", "--count",
                         "1", "--seed", "3", "--out", scratch.at("set")})
                .code,
            0);
  const auto ended = run_program(
      {"evaluate", scratch.at("set"), "--policy", "expert", "--modes", "M1,M3", "--out", scratch.at("run")});
  EXPECT_EQ(ended.code, 1) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("incomplete"));
  const auto episodes = json_lines(scratch.path() / "run/episodes.jsonl");
  ASSERT_EQ(episodes.size(), 2U);
  EXPECT_EQ(episodes[0]["success"], true);
  EXPECT_EQ(episodes[1]["end"], "errored");
  EXPECT_EQ(episodes[1]["error"]["kind"], "policy");
  EXPECT_THAT(episodes[1]["error"]["message"].get<std::string>(), HasSubstr("the expert has no plan: not-in-m3"));
}

/// Tasks of few actions.
const fs::path& short_tasks() {
  static const ScratchFolder kScratch;
  static const fs::path kFolder = [] {
    const auto ended = run_program({"generate", "--count", "12", "--seed", "27", "--rooms", "5", "--objects", "10",
                                    "--splits", "atomic", "--modes", "M1,M2,M3", "--out", kScratch.at("short")});
    EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
    return fs::path(kScratch.at("short"));
  }();
  return kFolder;
}

/// The chance that what is left of a list of commands, each with probability `kept`, and then `stop` reach the goal:
/// the sum over all that may be left. Tries two to the power of the number of commands.
double chance_of_success(const Environment& now, const std::vector<Command>& commands, std::size_t next, double kept) {
  if (now.over()) return now.privileged().success ? 1 : 0;
  Environment after = now.clone();
  if (next == commands.size()) {
    (void)after.step(R"({"action": "stop", "args": []})");
    return after.privileged().success ? 1 : 0;
  }
  (void)after.step(commands[next]);
  return kept * chance_of_success(after, commands, next + 1, kept) +
         (1 - kept) * chance_of_success(now, commands, next + 1, kept);
}

/// Tasks of a data set, and the chance that a noisy demonstration of each reaches its goal.
struct NoisyTasks {
  fs::path folder;
  std::vector<std::string> tasks;
  std::vector<double> chances;
};

/// Not all actions of a demonstration are needed: some tidy up, some looks find nothing. So each choice of them is
/// tried, in the tasks whose demonstrations are short enough for that.
NoisyTasks noisy_tasks(Mode mode, double kept) {
  constexpr std::size_t kMostActions = 8;
  NoisyTasks noisy{short_tasks(), {}, {}};
  const TaskSource tasks = source(noisy.folder);
  for (std::size_t position = 0; position < tasks.size(); ++position) {
    const auto shown = tasks.demonstration(position, mode);
    EXPECT_TRUE(shown);
    if (!shown || shown->steps.size() > kMostActions + 1) continue;
    std::vector<Command> commands;
    for (const StepRecord& step : shown->steps) commands.push_back(step.command);
    commands.pop_back();  // `stop`
    noisy.tasks.push_back(shown->task);
    noisy.chances.push_back(chance_of_success(environment_of(tasks, position, mode), commands, 0, kept));
  }
  return noisy;
}

struct NoiseCase {
  Mode mode;
  std::string noise;
};
class EvaluatePolicyNoise : public ::testing::TestWithParam<NoiseCase> {};

// The mean of the chances is the success rate, which the printed interval has to cover; and since it is the mean of
// these tasks, not of any, the rate is as near to it as draws of these tasks are in 95 of 100 cases.
TEST_P(EvaluatePolicyNoise, SucceedsAsOftenAsTheClosedFormSays) {
  constexpr int kRepeats = 20;
  const double kept = 1 - std::stod(GetParam().noise);
  const auto noisy = noisy_tasks(GetParam().mode, kept);
  const auto count = static_cast<double>(noisy.tasks.size());
  ASSERT_GE(count, 3);
  double mean = 0, variance = 0;
  for (const double chance : noisy.chances) {
    mean += chance / count;
    variance += chance * (1 - chance);
  }
  const double error = std::sqrt(variance / kRepeats) / count;

  const ScratchFolder scratch;
  const auto ended =
      run_program({"evaluate", noisy.folder.string(), "--policy", "noisy:" + GetParam().noise, "--modes",
                   std::string(name_of(GetParam().mode)), "--tasks", join(noisy.tasks, ","), "--repeats",
                   std::to_string(kRepeats), "--seed", "27", "--report-pictures", "0", "--out", scratch.at("run")});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json all = Json::parse(*read_file(scratch.path() / "run/results.json"))["modes"][0]["all"];
  const double rate = all["success_rate"], low = all["interval"][0], high = all["interval"][1];
  const auto percent = [](double share) { return std::to_string(static_cast<int>(std::floor(100 * share + 0.5))); };
  EXPECT_THAT(ended.out, HasSubstr("[" + percent(low) + ", " + percent(high) + "]"));
  EXPECT_LE(low, mean);
  EXPECT_GE(high, mean);
  EXPECT_NEAR(rate, mean, 1.96 * error);
  RecordProperty("tasks", static_cast<int>(noisy.tasks.size()));
  RecordProperty("closed_form", std::to_string(mean));
  RecordProperty("rate", std::to_string(rate) + " [" + std::to_string(low) + ", " + std::to_string(high) + "]");
}

INSTANTIATE_TEST_SUITE_P(Modes, EvaluatePolicyNoise,
                         ::testing::Values(NoiseCase{Mode::M1, "0.05"}, NoiseCase{Mode::M1, "0.1"},
                                           NoiseCase{Mode::M1, "0.2"}, NoiseCase{Mode::M2, "0.05"},
                                           NoiseCase{Mode::M2, "0.1"}, NoiseCase{Mode::M2, "0.2"},
                                           NoiseCase{Mode::M3, "0.05"}, NoiseCase{Mode::M3, "0.1"},
                                           NoiseCase{Mode::M3, "0.2"}),
                         [](const auto& one) {
                           std::string name = std::string(name_of(one.param.mode)) + "With" + one.param.noise;
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

}  // namespace
}  // namespace unietp
