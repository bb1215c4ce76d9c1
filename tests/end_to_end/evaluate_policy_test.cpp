// The program's own policies in `unietp evaluate`: the expert, and demonstrations with noise.
#include <algorithm>
#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "data_set.h"

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

struct NoiseCase {
  std::string mode, noise;
};
class EvaluatePolicyNoise : public ::testing::TestWithParam<NoiseCase> {};

// Of the demonstrations chosen here each action is needed, so one of n actions and `stop` succeeds with (1 - P)^n; in
// M3, where all search, at least as often. The mean of that over the tasks is the success rate, which the printed
// interval has to cover; and since it is the mean of these tasks, not of any, the rate is as near to it as draws of
// these tasks are in 95 of 100 cases.
TEST_P(EvaluatePolicyNoise, SucceedsAsOftenAsTheClosedFormSays) {
  constexpr int kRepeats = 20;
  const double kept = 1 - std::stod(GetParam().noise);
  std::string tasks;
  double mean = 0, variance = 0;
  int count = 0;
  for (const Json& shown : json_lines(tasks_of_all_splits() / "demonstrations" / (GetParam().mode + ".jsonl"))) {
    const bool searches = std::any_of(shown["steps"].begin(), shown["steps"].end(),
                                      [](const Json& step) { return step["search"] == true; });
    if (searches && GetParam().mode == "M2") continue;  // what is found later may have been in view before
    const double chance = std::pow(kept, static_cast<double>(shown["steps"].size()) - 1);
    tasks += (tasks.empty() ? "" : ",") + shown["task"].get<std::string>();
    mean += chance;
    variance += chance * (1 - chance);
    ++count;
  }
  ASSERT_GE(count, 3);
  mean /= count;
  const double error = std::sqrt(variance / kRepeats) / count;

  const ScratchFolder scratch;
  const auto ended = run_program({"evaluate", tasks_of_all_splits().string(), "--policy", "noisy:" + GetParam().noise,
                                  "--modes", GetParam().mode, "--tasks", tasks, "--repeats", std::to_string(kRepeats),
                                  "--seed", "27", "--report-pictures", "0", "--out", scratch.at("run")});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json all = Json::parse(*read_file(scratch.path() / "run/results.json"))["modes"][0]["all"];
  const double rate = all["success_rate"], low = all["interval"][0], high = all["interval"][1];
  const auto percent = [](double share) { return std::to_string(static_cast<int>(std::floor(100 * share + 0.5))); };
  EXPECT_THAT(ended.out, HasSubstr("[" + percent(low) + ", " + percent(high) + "]"));
  EXPECT_GE(high, mean);
  EXPECT_GE(rate, mean - 1.96 * error);
  if (GetParam().mode != "M3") {  // all of M3 search, and may succeed without a look
    EXPECT_LE(low, mean);
    EXPECT_LE(rate, mean + 1.96 * error);
  }
  RecordProperty("closed_form", std::to_string(mean));
  RecordProperty("rate", std::to_string(rate) + " [" + std::to_string(low) + ", " + std::to_string(high) + "]");
}

INSTANTIATE_TEST_SUITE_P(Modes, EvaluatePolicyNoise,
                         ::testing::Values(NoiseCase{"M1", "0.05"}, NoiseCase{"M1", "0.1"}, NoiseCase{"M1", "0.2"},
                                           NoiseCase{"M2", "0.05"}, NoiseCase{"M2", "0.1"}, NoiseCase{"M2", "0.2"},
                                           NoiseCase{"M3", "0.05"}, NoiseCase{"M3", "0.1"}),
                         [](const auto& one) {
                           std::string name = one.param.mode + "With" + one.param.noise;
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

}  // namespace
}  // namespace unietp
