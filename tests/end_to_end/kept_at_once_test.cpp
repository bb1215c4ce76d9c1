// Commands at once on one folder: each does its work, or refuses and names the other's process.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/folder_lock.h"
#include "tests/support/thorough.h"
#include "writing_commands.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using test::tries;
using ::testing::HasSubstr;
using Files = std::map<std::string, std::string>;

TEST(Kept, AFolderOfAnotherProcessIsNotTouchedAndTheProcessIsNamed) {
  for (const auto& command : writing_commands()) {
    // Single files have no lock, and what has one name and one content needs none.
    if (command.makes.find('.') != std::string::npos) continue;
    if (command.name == "knowledge build" || command.name == "template new") continue;
    SCOPED_TRACE(command.name);
    const Workbench bench;
    const auto lock = FolderLock::take(bench / command.makes);
    ASSERT_TRUE(lock);
    const auto before = bytes_below(bench.path());
    const auto ended = bench.run(command);
    EXPECT_EQ(ended.code, 2) << ended.out;
    EXPECT_THAT(ended.err, HasSubstr("process " + std::to_string(::getpid()) + " on "));
    EXPECT_EQ(bytes_below(bench.path()), before);
  }
}

TEST(Kept, CommandsAtOnceOnOneFolderGiveWholeFoldersAndNoFalseSuccess) {
  const auto of_seed = [](const std::string& seed) {
    return WritingCommand{"annotate", "annotate data --seed " + seed, "data"};
  };
  const auto first = undisturbed(of_seed("5")), second = undisturbed(of_seed("6"));
  const WritingCommand sft{"export", "export data --format sft --out out", "out"};
  std::vector<Files> exports{undisturbed(sft).after};
  for (const char* seed : {"5", "6"}) {
    const Workbench bench;
    ASSERT_EQ(bench.run(of_seed(seed)).code, 0);
    ASSERT_EQ(bench.run(sft).code, 0);
    exports.push_back(bench.files("out"));
  }
  for (int round = 0; round < tries(3, 10); ++round) {
    SCOPED_TRACE(round);
    const Workbench bench;
    RunningProgram one("/bin/sh", bench.words(of_seed("5")), bench.path());
    RunningProgram two("/bin/sh", bench.words(of_seed("6")), bench.path());
    RunningProgram three("/bin/sh", bench.words(sft), bench.path());
    RunningProgram four("/bin/sh", bench.words(sft), bench.path());
    const auto ends = std::array{one.wait(), two.wait(), three.wait(), four.wait()};
    for (const auto& ended : ends) EXPECT_TRUE(ended.code == 0 || ended.code == 2) << ended.code << ended.err;
    const auto data = bench.files("data");
    EXPECT_EQ(ends[0].code == 0 || ends[1].code == 0, data != first.before);
    EXPECT_TRUE(data == first.before || (ends[0].code == 0 && data == first.after) ||
                (ends[1].code == 0 && data == second.after));
    EXPECT_LE((ends[2].code == 0 ? 1 : 0) + (ends[3].code == 0 ? 1 : 0), 1);
    const auto out = bench.files("out");
    EXPECT_EQ(ends[2].code == 0 || ends[3].code == 0, !out.empty());
    if (!out.empty()) {
      EXPECT_NE(std::find(exports.begin(), exports.end(), out), exports.end());
    }
    EXPECT_FALSE(fs::exists(bench / "data.lock") || fs::exists(bench / "data.writing"));
    EXPECT_FALSE(fs::exists(bench / "out.lock") || fs::exists(bench / "out.writing"));
  }
}

/// What the folder `makes` has after commands in turn; nullopt when the last one fails.
std::optional<Files> after_in_turn(const std::vector<WritingCommand>& commands) {
  const Workbench bench;
  Ended ended;
  for (const auto& command : commands) ended = bench.run(command);
  if (ended.code != 0) return std::nullopt;
  return bench.files(commands.back().makes);
}

/// Runs two commands that make or change one folder at once: those that say 0 have done their work, in some order.
void expect_one_or_both_in_turn(const WritingCommand& one, const WritingCommand& two) {
  const auto only_one = after_in_turn({one}), only_two = after_in_turn({two});
  ASSERT_TRUE(only_one && only_two);
  const auto two_last = after_in_turn({one, two}), one_last = after_in_turn({two, one});
  for (int round = 0; round < tries(3, 10); ++round) {
    SCOPED_TRACE(one.name + " and " + two.name + ", round " + std::to_string(round));
    const Workbench bench;
    const auto others = bench.others(one);
    RunningProgram first("/bin/sh", bench.words(one), bench.path());
    RunningProgram second("/bin/sh", bench.words(two), bench.path());
    const auto first_ended = first.wait(), second_ended = second.wait();
    for (const auto* ended : {&first_ended, &second_ended})
      EXPECT_TRUE(ended->code == 0 || ended->code == 2) << ended->code << ended->err;
    const auto files = bench.files(one.makes);
    if (first_ended.code == 0 && second_ended.code == 0) {
      EXPECT_TRUE(files == two_last || files == one_last);
    } else {
      EXPECT_TRUE(first_ended.code == 0 || second_ended.code == 0) << first_ended.err << second_ended.err;
      EXPECT_EQ(files, first_ended.code == 0 ? only_one : only_two);
    }
    EXPECT_EQ(bench.others(one), others);  // no lock and nothing half made
  }
}

TEST(Kept, CommandsOfTwoKindsAtOnceOnOneFolderDoTheirWorkOrRefuse) {
  const auto generate = [](const std::string& seed) {
    return WritingCommand{"generate with seed " + seed, small_run(seed) + " --out out", "out"};
  };
  const WritingCommand annotate{"annotate", "annotate data --seed 5", "data"};
  const WritingCommand review{"review", "review data --apply review.json --accept-unchecked", "data"};
  const WritingCommand merge{"merge", "merge part-1 part-2 --out out", "out"};
  expect_one_or_both_in_turn(review, annotate);
  expect_one_or_both_in_turn(merge, generate("3"));
  expect_one_or_both_in_turn(generate("3"), generate("4"));
}

}  // namespace
}  // namespace unietp
