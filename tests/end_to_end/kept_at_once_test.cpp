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

/// How the last of some commands in turn ends, and what the folder `makes` has after it.
struct InTurn {
  int code = 0;
  Files files;
};
InTurn in_turn(const std::vector<WritingCommand>& commands) {
  const Workbench bench;
  InTurn last;
  for (const auto& command : commands) last.code = bench.run(command).code;
  last.files = bench.files(commands.back().makes);
  return last;
}

/// Runs two commands that make or change one folder at once: one does its work and the other refuses, or both do theirs
/// in some order, with the codes and files of that order. A review of texts that are written anew first ends with 1.
void expect_one_or_both_in_turn(const WritingCommand& one, const WritingCommand& two) {
  const auto only_one = in_turn({one}), only_two = in_turn({two});
  ASSERT_EQ(only_one.code, 0);
  ASSERT_EQ(only_two.code, 0);
  const auto two_last = in_turn({one, two}), one_last = in_turn({two, one});
  for (int round = 0; round < tries(3, 10); ++round) {
    SCOPED_TRACE(one.name + " and " + two.name + ", round " + std::to_string(round));
    const Workbench bench;
    const auto others = bench.others(one);
    RunningProgram first("/bin/sh", bench.words(one), bench.path());
    RunningProgram second("/bin/sh", bench.words(two), bench.path());
    const auto first_ended = first.wait(), second_ended = second.wait();
    const auto files = bench.files(one.makes);
    const auto is = [&](int first_code, int second_code, const Files& expected) {
      return first_ended.code == first_code && second_ended.code == second_code && files == expected;
    };
    EXPECT_TRUE(is(0, 2, only_one.files) || is(2, 0, only_two.files) || is(0, two_last.code, two_last.files) ||
                is(one_last.code, 0, one_last.files))
        << first_ended.code << first_ended.err << second_ended.code << second_ended.err;
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
