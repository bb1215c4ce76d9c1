// The scripts of deploy/slurm on a real Slurm of one node: an array of shards and the merge behind it give the bytes
// of one process, also when a shard was stopped before.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "cluster.h"
#include "core/files.h"

namespace unietp::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const std::string kSubmit = std::string(UNIETP_SOURCE_DIR) + "/deploy/slurm/submit.sh";
const std::string kSettings =
    R"({"format": "unietp-run/1", "seed": 5, "count": 8, "block": 2, "homes": "drawn", "rooms": 5, "objects": 25})";

std::string in_order(const fs::path& logs) {
  std::string text;
  for (const auto& [name, bytes] : bytes_below(logs)) text += name + ":\n" + bytes;
  return text;
}

TEST(Slurm, AnArrayOfShardsAndItsMergeGiveTheBytesOfOneProcess) {
  const SlurmCluster cluster;
  if (!cluster.why_not().empty())
    GTEST_SKIP() << "needs Slurm: install slurm-wlm and munge, run as root; it does not start: " << cluster.why_not();
  const ScratchFolder scratch;
  ASSERT_TRUE(write_file(scratch.path() / "run.json", kSettings));
  const auto alone = run_program({"training", "--config", scratch.at("run.json"), "--out", scratch.at("alone")});
  ASSERT_EQ(alone.code, 0) << alone.err;
  const auto submitted =
      run_script(cluster.environment() + kSubmit +
                     " --shards 3 --out cluster --memory 100M --wait -- training --config " + scratch.at("run.json"),
                 scratch.path());
  ASSERT_EQ(submitted.code, 0) << submitted.out << submitted.err << in_order(scratch.path() / "cluster.parts/logs");
  EXPECT_THAT(submitted.out, HasSubstr("3 shards"));
  EXPECT_EQ(bytes_below(scratch.path() / "cluster"), bytes_below(scratch.path() / "alone"));

  // The same again, with two parts lost.
  fs::remove_all(scratch.path() / "cluster");
  const fs::path parts = scratch.path() / "cluster.parts";
  fs::remove_all(parts / "part-2");
  fs::remove_all(parts / "part-3");
  const auto again =
      run_script(cluster.environment() + kSubmit +
                     " --shards 3 --out cluster --memory 100M --wait -- training --config " + scratch.at("run.json"),
                 scratch.path());
  ASSERT_EQ(again.code, 0) << again.out << again.err << in_order(parts / "logs");
  EXPECT_EQ(bytes_below(scratch.path() / "cluster"), bytes_below(scratch.path() / "alone"));
  EXPECT_THAT(in_order(parts / "logs"), HasSubstr("part 1 is there"));
}

TEST(Submit, TellsWhatItWantsBeforeAnythingIsSubmitted) {
  const ScratchFolder scratch;
  const auto help = run_script(kSubmit + " --help", scratch.path());
  EXPECT_EQ(help.code, 0);
  EXPECT_THAT(help.out, HasSubstr("--shards N"));
  const auto none = run_script(kSubmit + " --out x -- training", scratch.path());
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, HasSubstr("--shards needs an integer >= 2"));
  const auto own = run_script(kSubmit + " --shards 2 --out x -- training --shard 1/2", scratch.path());
  EXPECT_EQ(own.code, 2);
  EXPECT_THAT(own.err, HasSubstr("--shard is set by the jobs"));
  const auto other = run_script(kSubmit + " --shards 2 --out x -- validate", scratch.path());
  EXPECT_EQ(other.code, 2);
}

}  // namespace
}  // namespace unietp::testing
