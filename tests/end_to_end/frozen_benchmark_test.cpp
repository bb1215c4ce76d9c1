// A data set whose digest data/benchmarks.csv has is a named version of the benchmark, which is mixed with nothing
// else.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "data_set.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using ::testing::HasSubstr;

/// The committed data with another table of benchmarks.
fs::path data_with(const ScratchFolder& scratch, const std::string& table) {
  const fs::path checkout = UNIETP_SOURCE_DIR, root = scratch.path() / "root";
  fs::create_directories(root / "data");
  for (const auto& entry : fs::directory_iterator(checkout / "data")) {
    if (entry.path().filename() != "benchmarks.csv")
      fs::create_symlink(entry.path(), root / "data" / entry.path().filename());
  }
  fs::create_symlink(checkout / "templates", root / "templates");
  EXPECT_TRUE(write_file(root / "data" / "benchmarks.csv", table));
  return root;
}

TEST(FrozenBenchmark, IsNamedInEveryTableAndMixedWithNothingElse) {
  const ScratchFolder scratch;
  const std::string set = data_set_in_all_modes().string(), plain = scratch.at("plain"), named = scratch.at("named");
  ASSERT_EQ(run_program({"evaluate", set, "--policy", "stop", "--out", plain}).code, 0);
  const Json manifest = Json::parse(*read_file(fs::path(plain) / "manifest.json"));
  const std::string digest = manifest["setup"]["dataset"]["digest"];
  EXPECT_EQ(manifest["setup"]["dataset"]["version"], "");
  const std::string root = data_with(scratch, "name,digest\nunietp-9.9," + digest + "\n").string();

  const Ended ended = run_program({"--data", root, "evaluate", set, "--policy", "stop", "--out", named});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(Json::parse(*read_file(fs::path(named) / "results.json"))["benchmark"], "unietp-9.9");
  const std::string conditions = "Benchmark unietp-9.9, backend unietp, preset paper, unietp ";
  std::string table = *read_file(fs::path(named) / "tables.md");
  std::size_t tables = 0, stated = 0;
  for (auto at = table.find("\n## "); at != std::string::npos; at = table.find("\n## ", at + 1)) ++tables;
  for (auto at = table.find(conditions); at != std::string::npos; at = table.find(conditions, at + 1)) ++stated;
  EXPECT_GT(tables, 4U);
  EXPECT_EQ(stated, tables + (table.starts_with("## ") ? 1 : 0)) << "every table states on what it was made";
  EXPECT_THAT(*read_file(fs::path(named) / "report.html"), HasSubstr("unietp-9.9"));

  EXPECT_EQ(run_program({"--data", root, "validate", named, "--dataset", set}).code, 0);
  const Ended unknown = run_program({"validate", named, "--dataset", set});
  EXPECT_EQ(unknown.code, 1);
  EXPECT_THAT(unknown.out, HasSubstr("#/setup/dataset/version"));
  const Ended mixed = run_program({"compare", named, plain, "--out", scratch.at("board")});
  EXPECT_EQ(mixed.code, 2);
  EXPECT_THAT(mixed.err, HasSubstr("cannot be compared"));
  EXPECT_FALSE(fs::exists(scratch.at("board"))) << "no leaderboard of two benchmarks";
  const Ended alike = run_program({"compare", named, named, "--out", scratch.at("board")});
  EXPECT_EQ(alike.code, 0) << alike.err;
  EXPECT_THAT(*read_file(fs::path(scratch.at("board")) / "leaderboard.html"), HasSubstr("unietp-9.9"));
}

TEST(FrozenBenchmark, StandsInTheManifestAndIsCheckedAgainstTheTasks) {
  const ScratchFolder scratch;
  const auto make = [&](const std::string& root, const std::string& out) {
    return run_program({"--data", root, "generate", "--count", "4", "--seed", "3", "--modes", "M1", "--out", out});
  };
  const auto manifest_of = [](const std::string& folder) {
    return Json::parse(*read_file(fs::path(folder) / "manifest.json"));
  };
  const std::string plain = scratch.at("plain"), named = scratch.at("named"), worded = scratch.at("worded");
  ASSERT_EQ(make(UNIETP_SOURCE_DIR, plain).code, 0);
  EXPECT_FALSE(manifest_of(plain).contains("benchmark"));
  const std::string run = scratch.at("run");
  ASSERT_EQ(run_program({"evaluate", plain, "--policy", "stop", "--out", run}).code, 0);
  const std::string digest = manifest_of(run)["setup"]["dataset"]["digest"];
  const std::string root = data_with(scratch, "name,digest\nunietp-9.9," + digest + "\n").string();

  ASSERT_EQ(make(root, named).code, 0);
  EXPECT_EQ(manifest_of(named)["benchmark"], "unietp-9.9");
  EXPECT_EQ(*read_file(fs::path(named) / "tasks.jsonl"), *read_file(fs::path(plain) / "tasks.jsonl"));
  EXPECT_EQ(run_program({"--data", root, "validate", named}).code, 0);
  const Ended unknown = run_program({"validate", named});
  EXPECT_EQ(unknown.code, 1);
  EXPECT_THAT(unknown.out, HasSubstr("names the benchmark \"unietp-9.9\", but"));

  const Ended ended =
      run_program({"--data", root, "annotate", named, "--phrasings", "all", "--seed", "5", "--out", worded});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_NE(*read_file(fs::path(named) / "tasks.jsonl"), *read_file(fs::path(worded) / "tasks.jsonl"));
  EXPECT_FALSE(manifest_of(worded).contains("benchmark")) << "other words are another benchmark";

  Json unnamed = manifest_of(named);
  unnamed.erase("benchmark");
  ASSERT_TRUE(write_file(fs::path(named) / "manifest.json", unnamed.dump(2) + "\n"));
  EXPECT_EQ(run_program({"--data", root, "validate", named}).code, 0) << "made before it was frozen";
}

TEST(FrozenBenchmark, ATableThatIsNoneIsRefused) {
  const ScratchFolder scratch;
  const std::string root = data_with(scratch, "name,digest\nunietp-9.9,abc\n").string();
  const Ended ended = run_program(
      {"--data", root, "evaluate", data_set_in_all_modes().string(), "--policy", "stop", "--out", scratch.at("run")});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("benchmarks.csv:2:1"));
}

}  // namespace
}  // namespace unietp
