// The scripts of deploy/slurm on a real Slurm of one node: an array of shards and the merge behind it give the bytes
// of one process, also when a shard was stopped before.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "cluster.h"
#include "core/files.h"
#include "tests/end_to_end/file_watch.h"

namespace unietp::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const std::string kSubmit = std::string(UNIETP_SOURCE_DIR) + "/deploy/slurm/submit.sh";
const std::string kSettings =
    R"({"format": "unietp-run/1", "seed": 5, "count": 8, "block": 2, "homes": "drawn", "rooms": 5, "objects": 25})";

/// Changes of files after which a part of the run above is half made.
constexpr int kEventsOfHalfAPart = 12;

std::string in_order(const fs::path& logs) {
  std::string text;
  for (const auto& [name, bytes] : bytes_below(logs)) text += name + ":\n" + bytes;
  return text;
}

/// A cluster, and a folder with the settings of a run and the data set that one process makes of them.
class Slurm : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!cluster_.why_not().empty())
      GTEST_SKIP() << "needs Slurm: install slurm-wlm and munge, run as root; it does not start: "
                   << cluster_.why_not();
    ASSERT_TRUE(write_file(scratch_.path() / "run.json", kSettings));
    const auto alone = run_program(training("alone"));
    ASSERT_EQ(alone.code, 0) << alone.err;
  }

  std::vector<std::string> training(const std::string& out) const {
    return {"training", "--config", scratch_.at("run.json"), "--out", scratch_.at(out)};
  }
  Ended submit(const std::string& options = "") const {
    return run_script(cluster_.environment() + kSubmit + " --shards 3 --out cluster --memory 100M --wait " + options +
                          " -- training --config " + scratch_.at("run.json"),
                      scratch_.path());
  }
  fs::path parts() const { return scratch_.path() / "cluster.parts"; }
  std::string logs() const { return in_order(parts() / "logs"); }
  void expect_the_bytes_of_one_process() const {
    EXPECT_EQ(bytes_below(scratch_.path() / "cluster"), bytes_below(scratch_.path() / "alone"));
  }

  const SlurmCluster cluster_;
  const ScratchFolder scratch_;
};

TEST_F(Slurm, AnArrayOfShardsAndItsMergeGiveTheBytesOfOneProcess) {
  const auto submitted = submit();
  ASSERT_EQ(submitted.code, 0) << submitted.out << submitted.err << logs();
  EXPECT_THAT(submitted.out, HasSubstr("3 shards"));
  expect_the_bytes_of_one_process();

  // The same again, with a part lost and another one half made, as after a kill.
  fs::remove_all(scratch_.path() / "cluster");
  fs::remove_all(parts() / "part-2");
  fs::remove_all(parts() / "part-3");
  auto half = training("cluster.parts/part-3");
  half.insert(half.end(), {"--shard", "3/3", "--threads", "1"});
  FileWatch watch(parts());
  RunningProgram program(half);
  ASSERT_TRUE(killed_after(program, watch, kEventsOfHalfAPart));
  ASSERT_TRUE(fs::exists(parts() / "part-3.partial" / "run.json"));
  ASSERT_FALSE(fs::exists(parts() / "part-3"));
  const auto again = submit();
  ASSERT_EQ(again.code, 0) << again.out << again.err << logs();
  expect_the_bytes_of_one_process();
  EXPECT_THAT(logs(), HasSubstr("part 1 is there"));
}

TEST_F(Slurm, AShardThatFailsFailsTheWholeUntilItIsRedone) {
  const std::string failing = scratch_.at("failing");
  ASSERT_TRUE(write_file(failing,
                         "#!/bin/sh\ncase \"$*\" in *' 2/3 '*) echo 'the disk is full' && exit 2;; esac\n"
                         "exec unietp \"$@\"\n"));
  fs::permissions(failing, fs::perms::owner_all);
  const auto failed = submit("--program " + failing);
  EXPECT_EQ(failed.code, 2) << failed.out << logs();
  EXPECT_THAT(failed.err, HasSubstr("shard 2 failed: see "));
  EXPECT_THAT(failed.err, ::testing::Not(HasSubstr("shard 1 failed")));
  EXPECT_THAT(failed.err, HasSubstr("cluster was not made"));
  EXPECT_THAT(logs(), HasSubstr("the disk is full"));
  EXPECT_FALSE(fs::exists(scratch_.path() / "cluster"));

  const auto again = submit();
  ASSERT_EQ(again.code, 0) << again.out << again.err << logs();
  expect_the_bytes_of_one_process();
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
