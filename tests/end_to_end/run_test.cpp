// Data sets of given quotas, in parts and whole.
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "data_set.h"
#include "file_watch.h"

namespace unietp {
namespace {

using ::testing::HasSubstr;

/// A configuration of three blocks in the benchmark's homes, some thirty seconds less than the benchmark itself.
constexpr const char* kSmall = R"({
  "format": "unietp-run/1", "seed": 4, "homes": "benchmark", "block": 6,
  "quotas": {"splits": {"atomic": 6, "compositional": 7, "logical": 5},
             "simulators": {"ai2thor": 8, "virtualhome": 4, "habitat": 3, "behavior": 3}}})";

class QuotaRun : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(write_file(scratch_.at("small.json"), kSmall)); }
  Ended make(const std::string& out, std::vector<std::string> options = {}) {
    std::vector<std::string> all{"benchmark", "--config", scratch_.at("small.json"), "--out", scratch_.at(out)};
    all.insert(all.end(), options.begin(), options.end());
    return run_program(all);
  }
  ScratchFolder scratch_;
};

TEST_F(QuotaRun, ShardsPutTogetherAreTheBytesOfOneProcess) {
  ASSERT_EQ(make("whole").code, 0);
  std::map<std::string, int> simulators, splits;
  for (const auto& task : json_lines(scratch_.path() / "whole" / "tasks.jsonl")) {
    ++simulators[task["simulator"]];
    ++splits[task["split"]];
    EXPECT_THAT(task["layout"].get<std::string>(), HasSubstr("-benchmark-"));
  }
  EXPECT_EQ(simulators,
            (std::map<std::string, int>{{"ai2thor", 8}, {"virtualhome", 4}, {"habitat", 3}, {"behavior", 3}}));
  EXPECT_EQ(splits, (std::map<std::string, int>{{"atomic", 6}, {"compositional", 7}, {"logical", 5}}));

  // The first part is killed on its way; the threads are as many as they like.
  {
    const std::vector<std::string> part{"benchmark", "--config",           scratch_.at("small.json"),
                                        "--out",     scratch_.at("first"), "--shard",
                                        "1/2",       "--threads",          "8"};
    FileWatch watch(scratch_.path());
    RunningProgram program(part);
    EXPECT_TRUE(killed_after(program, watch, 40));
    EXPECT_FALSE(std::filesystem::exists(scratch_.path() / "first"));
  }
  ASSERT_EQ(make("first", {"--shard", "1/2", "--resume"}).code, 0);
  ASSERT_EQ(make("second", {"--shard", "2/2", "--threads", "1"}).code, 0);
  const auto merged =
      run_program({"merge", scratch_.at("second"), scratch_.at("first"), "--out", scratch_.at("merged")});
  EXPECT_EQ(merged.code, 0) << merged.err;
  EXPECT_EQ(bytes_below(scratch_.at("merged")), bytes_below(scratch_.at("whole")));

  // A part has the same bytes too, whoever makes it.
  ASSERT_EQ(make("again", {"--shard", "1/2", "--threads", "1"}).code, 0);
  EXPECT_EQ(bytes_below(scratch_.at("again")), bytes_below(scratch_.at("first")));

  const auto nowhere = run_program({"merge", scratch_.at("second"), scratch_.at("first")});
  EXPECT_EQ(nowhere.code, 2);
  EXPECT_THAT(nowhere.err, HasSubstr("--out is required"));
  const auto lacks = run_program({"merge", scratch_.at("second"), "--out", scratch_.at("half")});
  EXPECT_EQ(lacks.code, 2);
  EXPECT_THAT(lacks.err, HasSubstr("shard 1 of 2 is missing"));
  const auto twice = run_program({"merge", scratch_.at("first"), scratch_.at("first"), "--out", scratch_.at("half")});
  EXPECT_EQ(twice.code, 2);
  EXPECT_THAT(twice.err, HasSubstr("was already given"));
  const auto says = scratch_.path() / "first" / "shard.json";
  auto record = nlohmann::ordered_json::parse(*read_file(says));  // what names the run keeps its order
  record["blocks"][0][1] = 5;                                     // one task less than it has
  ASSERT_TRUE(write_file(says, record.dump()));
  const auto damaged =
      run_program({"merge", scratch_.at("first"), scratch_.at("second"), "--out", scratch_.at("half")});
  EXPECT_EQ(damaged.code, 2);
  EXPECT_THAT(damaged.err, HasSubstr("do not cover the run's 18 tasks exactly once"));
  EXPECT_FALSE(std::filesystem::exists(scratch_.at("half")));
}

/// What blind policies reach is part of the report of a whole benchmark, as `unietp audit` says it.
TEST_F(QuotaRun, VerifyingABenchmarkAuditsIt) {
  ASSERT_EQ(make("whole").code, 0);
  const auto ended = run_program({"validate", scratch_.at("whole"), "--json"});
  ASSERT_EQ(ended.code, 0) << ended.out << ended.err;
  const auto json = nlohmann::ordered_json::parse(ended.out);
  ASSERT_TRUE(json.contains("audit")) << ended.out;
  const auto audited = nlohmann::ordered_json::parse(run_program({"audit", scratch_.at("whole"), "--json"}).out);
  EXPECT_EQ(json["audit"]["cells"], audited["cells"].size());
  EXPECT_EQ(json["audit"]["leaks"].size(), audited["leaks"].get<std::size_t>());
  EXPECT_EQ(json["audit"]["training_tasks"], 0);
  const auto text = run_program({"validate", scratch_.at("whole")});
  EXPECT_THAT(text.out,
              HasSubstr("\n" + std::to_string(audited["leaks"].get<int>()) + " of " +
                        std::to_string(audited["cells"].size()) + " cells of the audit are better than chance\n"));
  const auto learned = run_program({"validate", scratch_.at("whole"), "--against", scratch_.at("whole"), "--json"});
  EXPECT_EQ(learned.code, 1) << "it shares all homes with itself";
  EXPECT_FALSE(nlohmann::ordered_json::parse(learned.out).contains("audit")) << "only a sound set is audited";
  ASSERT_EQ(run_program({"generate", "--count", "2", "--seed", "7", "--rooms", "5", "--objects", "25", "--simulators",
                         "habitat", "--out", scratch_.at("other")})
                .code,
            0);
  const auto other = run_program({"validate", scratch_.at("other"), "--json"});
  EXPECT_EQ(other.code, 0) << other.out;
  EXPECT_FALSE(nlohmann::ordered_json::parse(other.out).contains("audit")) << "no benchmark";
}

TEST_F(QuotaRun, RefusesWhatIsNoPartAndMorePartsThanBlocks) {
  for (const std::string part : {"0/2", "3/2", "2", "a/b", "1/2x"}) {
    const auto ended = make("out", {"--shard", part});
    EXPECT_EQ(ended.code, 2);
    EXPECT_THAT(ended.err, HasSubstr("expected K/N")) << part;
  }
  const auto many = make("out", {"--shard", "1/9"});
  EXPECT_EQ(many.code, 2);
  EXPECT_THAT(many.err, HasSubstr("has 3 blocks"));
}

/// The grades of 12 tasks that `generate` makes of templates whose categories people seldom bring together.
std::map<std::string, int> grades_with(const ScratchFolder& scratch, const std::string& sense) {
  const auto ended = run_program({"generate", "--count", "12", "--seed", "3", "--modes", "M1", "--simulators",
                                  "behavior", "--sense", sense, "--out", scratch.at(sense)});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(run_program({"validate", scratch.at(sense)}).code, 0);
  std::map<std::string, int> grades;
  for (const auto& task : json_lines(scratch.path() / sense / "tasks.jsonl")) ++grades[task["sense"]["grade"]];
  return grades;
}

TEST(Sense, OfTheTasksIsAtLeastWhatIsAskedFor) {
  const ScratchFolder scratch;
  const auto usual = grades_with(scratch, "usual"), tolerable = grades_with(scratch, "tolerable"),
             any = grades_with(scratch, "any");
  EXPECT_EQ(usual, (std::map<std::string, int>{{"usual", 12}}));
  EXPECT_FALSE(tolerable.contains("senseless"));
  EXPECT_TRUE(tolerable.contains("tolerable"));
  EXPECT_TRUE(any.contains("senseless"));
}

TEST(Training, ThreadsAndShardsGiveTheSameBytes) {
  ScratchFolder scratch;
  ASSERT_TRUE(write_file(scratch.at("small.json"), R"({"format": "unietp-run/1", "seed": 6, "count": 8, "block": 4,
    "simulators": ["habitat"], "splits": ["atomic"], "modes": ["M1", "M2"], "phrasings": "training",
    "homes": "training"})"));
  const auto make = [&](const std::string& out, std::vector<std::string> more) {
    std::vector<std::string> all{"training", "--config", scratch.at("small.json"), "--out", scratch.at(out)};
    all.insert(all.end(), more.begin(), more.end());
    const auto ended = run_program(all);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return bytes_below(scratch.at(out));
  };
  const auto whole = make("one", {"--threads", "1"});
  EXPECT_EQ(make("eight", {"--threads", "8"}), whole);
  (void)make("first", {"--shard", "1/2"});
  (void)make("second", {"--shard", "2/2"});
  const auto merged = run_program({"merge", scratch.at("first"), scratch.at("second"), "--out", scratch.at("merged")});
  EXPECT_EQ(merged.code, 0) << merged.err;
  EXPECT_EQ(bytes_below(scratch.at("merged")), whole);
}

TEST(Training, LeavesOutASimulatorAndTheTemplatesHeldOutAndSharesNoHomeWithTheBenchmark) {
  ScratchFolder scratch;
  const auto ended = run_program({"training", "--count", "12", "--without-simulator", "ai2thor,behavior",
                                  "--hold-out-templates", "--out", scratch.at("out")});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto held_out = read_file(std::filesystem::path(UNIETP_SOURCE_DIR) / "data/runs/held_out_templates.txt");
  ASSERT_TRUE(held_out);
  for (const auto& task : json_lines(scratch.path() / "out" / "tasks.jsonl")) {
    EXPECT_TRUE(task["simulator"] == "virtualhome" || task["simulator"] == "habitat");
    EXPECT_THAT(*held_out, ::testing::Not(HasSubstr("\n" + task["template"].get<std::string>() + "\n")));
    EXPECT_THAT(task["layout"].get<std::string>(), HasSubstr("-training-"));
  }
}

}  // namespace
}  // namespace unietp
