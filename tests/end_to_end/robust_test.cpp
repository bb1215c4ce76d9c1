// Runs that are cut short, by a kill, an interrupt or a full disk, and what is left of them.
#include <signal.h>

#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "core/rng.h"
#include "core/text.h"
#include "data_set.h"
#include "file_watch.h"
#include "tests/support/sqlite_client.h"
#include "tests/support/thorough.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

/// A run of a few seconds: three tasks in two small homes.
std::vector<std::string> tiny_options(const std::string& out) {
  return {"generate",     "--count", "3",        "--seed", "3",         "--rooms", "5",     "--objects", "5",
          "--simulators", "habitat", "--splits", "atomic", "--threads", "2",       "--out", out};
}

const std::map<std::string, std::string>& tiny_bytes() {
  static const std::map<std::string, std::string> kBytes = [] {
    const ScratchFolder folder;
    const auto ended = run_program(tiny_options(folder.at("out")));
    EXPECT_EQ(ended.code, 0) << ended.err;
    return bytes_below(folder.at("out"));
  }();
  return kBytes;
}

TEST(Robust, KilledAtRandomAndResumedGivesTheSameBytes) {
  ScratchFolder folder;
  auto options = tiny_options(folder.at("out"));
  options.emplace_back("--resume");
  int whole = 0;
  {
    FileWatch watch(folder.path());
    RunningProgram program(options);
    while (program.running()) (void)watch.count();
    whole = watch.count();
    ASSERT_EQ(bytes_below(folder.at("out")), tiny_bytes());
    fs::remove_all(folder.at("out"));
  }
  ASSERT_GT(whole, 30);
  Rng rng(50);
  int finished = 0;
  for (int kills = 0; kills < test::tries(12, 50);) {
    FileWatch watch(folder.path());
    RunningProgram program(options);
    if (killed_after(program, watch, 1 + static_cast<int>(rng.below(static_cast<std::uint64_t>(whole))))) {
      ++kills;
      // Whole or not at all: what stands there was renamed into place just before the kill.
      if (fs::exists(folder.at("out"))) {
        ASSERT_EQ(bytes_below(folder.at("out")), tiny_bytes());
        if (!fs::exists(folder.at("out.partial"))) fs::remove_all(folder.at("out"));  // all was done; the next is anew
      }
      continue;
    }
    const auto ended = program.wait();
    ASSERT_EQ(ended.code, 0) << ended.err;
    ASSERT_EQ(bytes_below(folder.at("out")), tiny_bytes());
    ASSERT_FALSE(fs::exists(folder.at("out.partial")));
    fs::remove_all(folder.at("out"));
    ++finished;
  }
  const auto ended = run_program(options);
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(bytes_below(folder.at("out")), tiny_bytes());
  EXPECT_FALSE(fs::exists(folder.at("out.partial")));
  RecordProperty("finished", finished);
}

/// In a name space of its own, so that nothing is left mounted.
bool can_mount() {
  const ScratchFolder folder;
  return run_script("unshare -Urm mount -t tmpfs none " + folder.at(""), folder.path()).code == 0;
}

std::string joined(const std::vector<std::string>& words) { return "unietp " + join(words, " "); }

TEST(Robust, AFullDiskIsToldAndAResumeAfterMakingRoomGivesTheSameBytes) {
  if (!can_mount()) GTEST_SKIP() << "needs to mount a small disk: run as root, or allow user namespaces";
  ScratchFolder folder;
  fs::create_directory(folder.at("disk"));
  // The disk grows until there is room: at first for not even the ledger, then for it but not for the data set beside
  // it.
  const auto run = joined(tiny_options("disk/out")) + " --resume 2> message";
  ASSERT_TRUE(write_file(folder.at("script"),
                         "size=40; mount -t tmpfs -o size=${size}k none disk\n"
                         "until " +
                             run +
                             "; do\n"
                             "  echo $? >> codes; cat message >> messages; ls disk >> lists\n"
                             "  size=$((size + 40)); mount -o remount,size=${size}k disk\n"
                             "done\n"
                             "cp -r disk/out out\n"));
  const auto ended = run_script("unshare -Urm sh -e script", folder.path());
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(bytes_below(folder.at("out")), tiny_bytes());
  const auto codes = read_file(folder.at("codes")), messages = read_file(folder.at("messages")),
             lists = read_file(folder.at("lists"));
  ASSERT_TRUE(codes && messages && lists);
  const auto failures = split(*codes, '\n').size() - 1;
  EXPECT_GE(failures, 2U);
  EXPECT_EQ(replace_all(*codes, "2\n", ""), "");            // bad surroundings, not a wrong result
  EXPECT_EQ(replace_all(*lists, "out.partial\n", ""), "");  // nothing half published
  std::size_t told = 0;
  for (const auto& line : split(*messages, '\n')) told += line.find("--resume") != std::string::npos ? 1 : 0;
  EXPECT_EQ(told, failures);
  EXPECT_THAT(*messages, HasSubstr("full"));
}

/// The same without a disk of one's own: no file may grow beyond a limit.
TEST(Robust, AFileThatCannotGrowIsToldAndAResumeGivesTheSameBytes) {
  ScratchFolder folder;
  const auto options = joined(tiny_options("out"));
  const auto limited = run_script("trap '' XFSZ; ulimit -f 20; " + options, folder.path());
  EXPECT_EQ(limited.code, 2) << limited.err;
  EXPECT_THAT(limited.err, HasSubstr("--resume"));
  EXPECT_FALSE(fs::exists(folder.at("out")));
  const auto ended = run_script(options + " --resume", folder.path());
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(bytes_below(folder.at("out")), tiny_bytes());
}

/// Waits until the run has made its folder.
void wait_for_ledger(RunningProgram& program, const fs::path& folder) {
  FileWatch watch(folder);
  while (program.running() && !fs::exists(folder / "out.partial/ledger.sqlite")) (void)watch.count();
}

TEST(Robust, AnInterruptEndsCleanlyWithTheWayToGoOn) {
  ScratchFolder folder;
  const auto options = small_options(folder.at("out"));
  RunningProgram program(options);
  wait_for_ledger(program, folder.path());
  program.send(SIGINT);
  const auto ended = program.wait();
  EXPECT_EQ(ended.code, 130) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("--resume"));
  EXPECT_FALSE(fs::exists(folder.at("out")));

  const auto refused = run_program(options);
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("add --resume"));
  auto other = options;
  other[4] = "8";  // the seed
  other.emplace_back("--resume");
  const auto mismatch = run_program(other);
  EXPECT_EQ(mismatch.code, 2);
  EXPECT_THAT(mismatch.err, HasSubstr("different settings"));
}

TEST(Robust, ASecondRunOnTheSameFolderIsRefused) {
  ScratchFolder folder;
  auto options = small_options(folder.at("out"));
  options.emplace_back("--resume");
  RunningProgram first(options);
  wait_for_ledger(first, folder.path());
  first.send(SIGSTOP);  // so that it is still at it, however quick it is
  const auto second = run_program(options);
  EXPECT_EQ(second.code, 2);
  EXPECT_THAT(second.err, HasSubstr("is working on this folder"));
  first.send(SIGKILL);
}

TEST(Robust, TheLedgerHasEveryCandidateWithStageReasonAndCost) {
  ScratchFolder folder;
  auto options = tiny_options(folder.at("out"));
  options.insert(options.end(), {"--ledger", folder.at("ledger.sqlite")});
  const auto ended = run_program(options);
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(bytes_below(folder.at("out")), tiny_bytes());  // costs are no part of it
  const auto rejected = json_lines(folder.path() / "out/rejections.jsonl").size();
  test::SqliteClient ledger(folder.at("ledger.sqlite"));
  std::size_t made = 0, given_up = 0;
  for (const auto& row : ledger.rows("SELECT accepted, stage, reason, seconds FROM outcome ORDER BY slot, attempt")) {
    const bool accepted = row.at(0) != "0";
    ++(accepted ? made : given_up);
    EXPECT_EQ(accepted, row.at(1).empty());
    EXPECT_EQ(accepted, row.at(2).empty());
    EXPECT_GT(std::stod(row.at(3)), 0);
  }
  EXPECT_EQ(made, 3U);
  EXPECT_EQ(given_up, rejected);
}

TEST(Robust, OnATerminalRateYieldAndTimeLeftAreShown) {
  ScratchFolder folder;
  const auto ended = run_script(
      "command -v script > found || exit 99; script -qec '" + joined(tiny_options("out")) + "' shown > /dev/null",
      folder.path());
  if (ended.code == 99) GTEST_SKIP() << "needs `script` to make a terminal: install bsdutils";
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto shown = read_file(folder.at("shown"));
  ASSERT_TRUE(shown);
  for (const char* words : {" of 3 tasks", "yield ", "tasks/s", " left"}) EXPECT_THAT(*shown, HasSubstr(words));
  const auto plain = run_script(joined(tiny_options("again")), folder.path());
  EXPECT_THAT(plain.err, Not(HasSubstr("tasks/s")));  // no terminal, no line
}

}  // namespace
}  // namespace unietp
