#include "run/run_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

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
  auto run = RunFolder::enter(out_, false);
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
  { ASSERT_TRUE(RunFolder::enter(out_, false)); }
  const auto again = RunFolder::enter(out_, false);
  ASSERT_FALSE(again);
  EXPECT_THAT(again.error().message, HasSubstr("--resume"));
  EXPECT_TRUE(RunFolder::enter(out_, true));
}

TEST_F(OutFolder, TwoRunsAtOnceAreRefused) {
  const auto first = RunFolder::enter(out_, false);
  ASSERT_TRUE(first);
  const auto second = RunFolder::enter(out_, true);
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error().message, HasSubstr("another run"));
}

TEST_F(OutFolder, AFinishedOneIsNotTouched) {
  fs::create_directories(out_);
  EXPECT_FALSE(RunFolder::enter(out_, false));
  EXPECT_FALSE(RunFolder::enter(out_, true));
  EXPECT_FALSE(fs::exists(partial_));
}

/// Killed after the rename and before the tidying: the data set is whole, only the rest has to go.
TEST_F(OutFolder, ARunKilledBetweenRenameAndTidyingIsTidiedByResume) {
  fs::create_directories(out_);
  ASSERT_TRUE(write_file(partial_ / "ledger.sqlite", ""));
  ASSERT_TRUE(write_file(partial_ / "publishing", ""));
  EXPECT_FALSE(RunFolder::enter(out_, false));
  const auto run = RunFolder::enter(out_, true);
  ASSERT_TRUE(run) << format(run.error());
  EXPECT_TRUE(run->already_published());
  EXPECT_FALSE(fs::exists(partial_));
  EXPECT_TRUE(fs::exists(out_));
}

TEST_F(OutFolder, HalfWrittenDataIsWrittenAnew) {
  auto run = RunFolder::enter(out_, false);
  ASSERT_TRUE(run);
  ASSERT_TRUE(write_file(partial_ / "data" / "half.txt", "half"));
  const auto data = run->fresh_data_folder();
  ASSERT_TRUE(data);
  EXPECT_TRUE(fs::is_empty(*data));
}

}  // namespace
}  // namespace unietp
