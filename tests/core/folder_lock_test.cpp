// One process at a time makes, changes or replaces a folder, and the last good one is never lost.
#include "core/folder_lock.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#include "core/files.h"
#include "core/staged_folder.h"
#include "tests/support/folder_remover.h"
#include "tests/support/refused_calls.h"
#include "tests/support/scratch_folder.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

using Names = std::vector<std::string>;

TEST(FolderLock, ASecondOneIsRefusedWithTheProcessThatHasIt) {
  const ScratchFolder folder;
  {
    const auto first = FolderLock::take(folder.at("data"));
    ASSERT_TRUE(first);
    fs::create_directory(folder.at("data"));
    fs::create_directory_symlink("data", folder.at("link"));
    for (const auto& name : {folder.at("data"), folder.at("data") + "/", folder.at("link"), folder.at("./x/../data")}) {
      const auto second = FolderLock::take(name);
      ASSERT_FALSE(second) << name;
      EXPECT_EQ(second.error().kind, Error::Kind::Usage);
      EXPECT_THAT(second.error().message, HasSubstr("process " + std::to_string(::getpid()) + " on "));
      EXPECT_THAT(second.error().message, HasSubstr("core_tests"));
    }
    EXPECT_TRUE(fs::exists(folder.at("data.lock")));
  }
  EXPECT_EQ(names_in(folder.path()), (Names{"data", "link"}));
  EXPECT_TRUE(FolderLock::take(folder.at("data")));
}

TEST(FolderLock, IsTakenThoughTheFoldersAboveAreRemovedMeanwhile) {
  constexpr int kRounds = 200, kSweeps = 20;
  const ScratchFolder folder;
  FolderRemover remover({folder.at("a/b/c"), folder.at("a/b"), folder.at("a")});
  for (int round = 0; round < kRounds; ++round) {
    remover.sweep(kSweeps);
    const auto lock = FolderLock::take(folder.at("a/b/c/data"));
    ASSERT_TRUE(lock) << "round " << round << ": " << lock.error().message;
  }
}

TEST(FolderLock, OneThatAKilledProcessHadIsFree) {
  const ScratchFolder folder;
  std::array<int, 2> ready{};
  ASSERT_EQ(::pipe(ready.data()), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const auto lock = FolderLock::take(folder.at("data"));
    (void)!::write(ready[1], "x", 1);
    for (;;) ::pause();
  }
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  const auto refused = FolderLock::take(folder.at("data"));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("process " + std::to_string(child)));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(fs::exists(folder.at("data.lock")));
  {
    const auto lock = FolderLock::take(folder.at("data"));
    ASSERT_TRUE(lock) << format(lock.error());
    EXPECT_TRUE(lock->was_left_over());
  }
  EXPECT_FALSE(fs::exists(folder.at("data.lock")));
  EXPECT_FALSE(FolderLock::take(folder.at("data"))->was_left_over());
}

TEST(FolderLock, APlaceThatCannotBeWrittenIsAnError) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.at("file"), ""));
  for (const auto& bad : {folder.path() / "file" / "data", fs::path("/proc/unietp/data")}) {
    const auto refused = FolderLock::take(bad);
    ASSERT_FALSE(refused) << bad;
    EXPECT_EQ(refused.error().kind, Error::Kind::Io);
    EXPECT_THAT(refused.error().message, HasSubstr("choose a folder that you can write to"));
  }
}

/// A folder `data` with a file, and how a new one takes its place.
class Staged : public ::testing::Test {
 protected:
  Staged() {
    EXPECT_TRUE(write_file(data() / "old", "old"));
    EXPECT_TRUE(write_file(data() / "kept" / "deep", "kept"));
  }
  fs::path data() const { return folder_.path() / "data"; }
  Result<ChangedCopy> changed(const fs::path& target) const {
    return ChangedCopy::begin(data(), target, [](const std::string& file) { return file == "old"; });
  }
  void expect_old() const {
    EXPECT_EQ(names_in(data()), (Names{"kept", "old"}));
    EXPECT_EQ(*read_file(data() / "old"), "old");
  }
  ScratchFolder folder_;
};

TEST_F(Staged, ReplacesTheFolderInOneStep) {
  {
    auto copy = changed(data());
    ASSERT_TRUE(copy) << format(copy.error());
    ASSERT_TRUE(write_file(copy->folder() / "new", "new"));
    expect_old();
    ASSERT_TRUE(copy->finish());
  }
  EXPECT_EQ(names_in(data()), (Names{"kept", "new"}));
  EXPECT_EQ(*read_file(data() / "kept" / "deep"), "kept");
  EXPECT_EQ(names_in(folder_.path()), Names{"data"});
}

TEST_F(Staged, OneThatIsNotFinishedLeavesAllAsItWas) {
  {
    const auto copy = changed(data());
    ASSERT_TRUE(copy);
    ASSERT_TRUE(write_file(copy->folder() / "new", "new"));
  }
  expect_old();
  EXPECT_EQ(names_in(folder_.path()), Names{"data"});
}

TEST_F(Staged, ThroughALinkTheFolderItselfIsReplaced) {
  fs::create_directory_symlink("data", folder_.at("link"));
  auto copy = ChangedCopy::begin(folder_.at("link"), folder_.at("link") + "/", [](const std::string&) { return true; });
  ASSERT_TRUE(copy) << format(copy.error());
  ASSERT_TRUE(copy->finish());
  EXPECT_TRUE(fs::is_symlink(folder_.at("link")));
  EXPECT_EQ(names_in(data()), Names{});
}

TEST_F(Staged, ACopyToAnotherPlaceHasFilesOfItsOwn) {
  auto copy = changed(folder_.path() / "other");
  ASSERT_TRUE(copy && copy->finish());
  EXPECT_EQ(names_in(folder_.path() / "other"), Names{"kept"});
  EXPECT_EQ(fs::hard_link_count(data() / "kept" / "deep"), 1U);
}

TEST_F(Staged, WhatIsThereIsNotTouched) {
  EXPECT_FALSE(StagedFolder::begin(data(), false));
  ASSERT_TRUE(write_file(folder_.path() / "data.writing" / "mine", "mine"));
  const auto refused = changed(data());
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("in the way"));
  EXPECT_EQ(*read_file(folder_.path() / "data.writing" / "mine"), "mine");
  expect_old();
  EXPECT_FALSE(ChangedCopy::begin(folder_.at("none"), folder_.at("none"), [](const std::string&) { return true; }));
  EXPECT_EQ(names_in(folder_.path()), (Names{"data", "data.writing"}));
}

TEST_F(Staged, WhatAKilledProcessLeftGoes) {
  ASSERT_TRUE(write_file(folder_.path() / "data.writing" / "half", "half"));
  ASSERT_TRUE(write_file(folder_.path() / "data.lock", "process 1 on here"));
  auto copy = changed(data());
  ASSERT_TRUE(copy) << format(copy.error());
  ASSERT_TRUE(copy->finish());
  EXPECT_EQ(names_in(data()), Names{"kept"});
}

TEST_F(Staged, ASourceThatIsReplacedWhileItIsReadIsNoticed) {
  const auto result = write_staged_folder(data(), folder_.path() / "out", [&](const fs::path& aside) -> Result<Done> {
    auto other = changed(data());
    EXPECT_TRUE(other && other->finish());
    return write_file(aside / "made", "of two folders");
  });
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, Error::Kind::Usage);
  EXPECT_THAT(result.error().message, HasSubstr("run this command again"));
  EXPECT_EQ(names_in(folder_.path()), Names{"data"});
}

TEST_F(Staged, WhereFoldersCannotChangePlacesTheNewOneStillComesWhole) {
  const RefusedExchange refused;
  {
    auto copy = changed(data());
    ASSERT_TRUE(copy);
    ASSERT_TRUE(write_file(copy->folder() / "new", "new"));
    ASSERT_TRUE(copy->finish());
  }
  EXPECT_EQ(names_in(data()), (Names{"kept", "new"}));
  EXPECT_EQ(names_in(folder_.path()), Names{"data"});
}

TEST_F(Staged, AKillWhenNeitherFolderHasTheNameLosesNothing) {
  fs::rename(data(), folder_.path() / "data.replaced");
  ASSERT_TRUE(write_file(folder_.path() / "data.writing" / "new", "new"));
  ASSERT_TRUE(write_file(folder_.path() / "data.lock", "process 1 on here"));
  { ASSERT_TRUE(changed(data())); }
  expect_old();
  EXPECT_EQ(names_in(folder_.path()), Names{"data"});
}

}  // namespace
}  // namespace unietp
