#include "run/run_folder.h"

#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr const char* kRun = R"({"version":"2","configuration":{"seed":3,"count":40}})";

class OutFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    base_ = fs::path(::testing::TempDir()) /
            (std::string("run_folder_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(base_);
    out_ = base_ / "out";
    partial_ = base_ / "out.partial";
  }
  void TearDown() override { fs::remove_all(base_); }
  fs::path base_, out_, partial_;
};

TEST_F(OutFolder, PublishesByOneRenameAndLeavesNothingElse) {
  auto run = RunFolder::enter(out_, kRun, false);
  ASSERT_TRUE(run) << format(run.error());
  const auto data = run->fresh_data_folder();
  ASSERT_TRUE(data);
  ASSERT_TRUE(write_file(*data / "a.txt", "a"));
  EXPECT_FALSE(fs::exists(out_));
  ASSERT_TRUE(run->publish());
  EXPECT_TRUE(fs::exists(out_ / "a.txt"));
  EXPECT_FALSE(fs::exists(partial_));
}

TEST_F(OutFolder, AnUnfinishedRunIsKeptAndNeedsResume) {
  { ASSERT_TRUE(RunFolder::enter(out_, kRun, false)); }
  const auto again = RunFolder::enter(out_, kRun, false);
  ASSERT_FALSE(again);
  EXPECT_THAT(again.error().message, HasSubstr("--resume"));
  EXPECT_TRUE(RunFolder::enter(out_, kRun, true));
}

TEST_F(OutFolder, TwoRunsAtOnceAreRefused) {
  const auto first = RunFolder::enter(out_, kRun, false);
  ASSERT_TRUE(first);
  const auto second = RunFolder::enter(out_, kRun, true);
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error().message, HasSubstr("is working on this folder"));
}

TEST_F(OutFolder, AFinishedOneIsNotTouched) {
  fs::create_directories(out_);
  EXPECT_FALSE(RunFolder::enter(out_, kRun, false));
  EXPECT_FALSE(RunFolder::enter(out_, kRun, true));
  EXPECT_FALSE(fs::exists(partial_));
}

/// Killed after the rename and before the tidying: the data set is whole, only the rest has to go.
TEST_F(OutFolder, ARunKilledBetweenRenameAndTidyingIsTidiedByResume) {
  fs::create_directories(out_);
  ASSERT_TRUE(write_file(partial_ / "ledger.sqlite", ""));
  ASSERT_TRUE(write_file(partial_ / "publishing", kRun));
  EXPECT_FALSE(RunFolder::enter(out_, kRun, false));
  const auto run = RunFolder::enter(out_, kRun, true);
  ASSERT_TRUE(run) << format(run.error());
  EXPECT_TRUE(run->already_published());
  EXPECT_FALSE(fs::exists(partial_));
  EXPECT_TRUE(fs::exists(out_));
}

/// Every file below a folder, with its bytes.
std::map<std::string, std::string> all_below(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    files[entry.path().string()] = entry.is_regular_file() ? *read_file(entry.path()) : "";
  return files;
}

TEST_F(OutFolder, ARunOfOtherOptionsOrAnotherVersionIsNotTouchedAndTheDifferenceTold) {
  { ASSERT_TRUE(RunFolder::enter(out_, kRun, false)); }
  ASSERT_TRUE(write_file(partial_ / "ledger.sqlite", "work"));
  ASSERT_TRUE(write_file(partial_ / "data" / "half.txt", "half"));
  const auto before = all_below(base_);
  const auto refused =
      RunFolder::enter(out_, R"({"version":"3","configuration":{"seed":4,"count":40,"modes":["M1"]}})", true);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, Error::Kind::Usage);
  EXPECT_THAT(refused.error().message, HasSubstr("different settings"));
  EXPECT_THAT(refused.error().message, HasSubstr("/version was \"2\" and is \"3\""));
  EXPECT_THAT(refused.error().message, HasSubstr("/configuration/seed was 3 and is 4"));
  EXPECT_THAT(refused.error().message, HasSubstr("/configuration/modes/0 was nothing and is \"M1\""));
  EXPECT_THAT(refused.error().message, ::testing::Not(HasSubstr("count")));
  EXPECT_EQ(all_below(base_), before);
}

TEST_F(OutFolder, AnOlderVersionsRunIsNotTouched) {
  ASSERT_TRUE(write_file(partial_ / "ledger.sqlite", "of a version that did not say which run it is"));
  ASSERT_TRUE(write_file(partial_ / "lock", ""));
  const auto before = all_below(base_);
  const auto refused = RunFolder::enter(out_, kRun, true);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("another version"));
  EXPECT_EQ(all_below(base_), before);
}

TEST_F(OutFolder, WhatOtherOptionsPublishedIsNotTidied) {
  fs::create_directories(out_);
  ASSERT_TRUE(write_file(partial_ / "publishing", kRun));
  const auto before = all_below(base_);
  EXPECT_FALSE(RunFolder::enter(out_, "{}", true));
  EXPECT_EQ(all_below(base_), before);
}

TEST_F(OutFolder, AKillBetweenMarkingAndPublishingIsGoneOnFrom) {
  { ASSERT_TRUE(RunFolder::enter(out_, kRun, false)); }
  fs::rename(partial_ / "run.json", partial_ / "publishing");
  ASSERT_TRUE(write_file(partial_ / "data" / "whole.txt", "whole"));
  auto run = RunFolder::enter(out_, kRun, true);
  ASSERT_TRUE(run) << format(run.error());
  EXPECT_FALSE(run->already_published());
  ASSERT_TRUE(run->publish());
  EXPECT_TRUE(fs::exists(out_ / "whole.txt"));
  EXPECT_FALSE(fs::exists(partial_));
}

TEST_F(OutFolder, HalfWrittenDataIsWrittenAnew) {
  auto run = RunFolder::enter(out_, kRun, false);
  ASSERT_TRUE(run);
  ASSERT_TRUE(write_file(partial_ / "data" / "half.txt", "half"));
  const auto data = run->fresh_data_folder();
  ASSERT_TRUE(data);
  EXPECT_TRUE(fs::is_empty(*data));
}

}  // namespace
}  // namespace unietp
