#include "rewording/batch_folder.h"

#include <gmock/gmock.h>

#include <array>
#include <barrier>
#include <filesystem>
#include <stop_token>
#include <thread>

#include "core/files.h"
#include "tests/support/folder_remover.h"
#include "tests/support/scratch_folder.h"

namespace unietp {
namespace {

using ::testing::ElementsAre;

/// The request files that a run adds to a folder with these files in it.
std::vector<std::string> added_to(const std::vector<std::string>& files) {
  const ScratchFolder folder;
  for (const auto& file : files) EXPECT_TRUE(write_file(folder.path() / file, ""));
  auto batch = BatchFolder::open(folder.path(), "model");
  EXPECT_TRUE(batch);
  (void)batch->ask({{"system", "user", "answer", "{\"type\":\"object\"}", {}, {}}});
  const auto report = batch->finish();
  EXPECT_TRUE(report);
  std::vector<std::string> names;
  for (const auto& file : report->new_files) names.push_back(file.filename().string());
  return names;
}

TEST(BatchFolder, CountsOnFromTheLastRequestFile) {
  EXPECT_THAT(added_to({}), ElementsAre("requests-0001.jsonl"));
  EXPECT_THAT(added_to({"requests-0003.jsonl", "answers.jsonl"}), ElementsAre("requests-0004.jsonl"));
}

TEST(BatchFolder, TakesAFileOfAnAbsurdNumberForNoneOfItsOwn) {
  EXPECT_THAT(added_to({"requests-2147483647.jsonl", "requests-99999999999999.jsonl", "requests-.jsonl"}),
              ElementsAre("requests-0001.jsonl"));
}

TEST(BatchFolder, IsNotLeftBehindEmpty) {
  const ScratchFolder folder;
  const auto inner = folder.path() / "new" / "batch";
  ASSERT_TRUE(BatchFolder::open(inner, "model"));  // ends at once, as in a run that then finds no data set
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  std::filesystem::create_directories(inner);
  ASSERT_TRUE(BatchFolder::open(inner, "model"));
  EXPECT_TRUE(std::filesystem::exists(inner)) << "it was there before";
  std::filesystem::remove_all(folder.path() / "new");
  {
    auto batch = BatchFolder::open(inner, "model");
    ASSERT_TRUE(batch);
    (void)batch->ask({{"system", "user", "answer", "{\"type\":\"object\"}", {}, {}}});
    ASSERT_TRUE(batch->finish());
  }
  EXPECT_TRUE(std::filesystem::exists(inner / "requests-0001.jsonl"));
}

/// One of two runs may be refused; the one that is not finds its folder until its end. In every other round it ends
/// only after the other was refused.
TEST(BatchFolder, IsNotTakenAwayByAnotherRunThatBeginsOrEndsAtTheSameTime) {
  constexpr int kRounds = 40;
  const ScratchFolder folder;
  std::array<int, 2> written{};
  std::barrier both(2);
  const auto run = [&](std::size_t which) {
    const std::string own = "user " + std::to_string(which);
    for (int round = 0; round < kRounds; ++round) {
      both.arrive_and_wait();
      auto batch = BatchFolder::open(folder.path() / std::to_string(round) / "new" / "batch", "model");
      if (round % 2 == 0) both.arrive_and_wait();
      if (!batch) {
        EXPECT_EQ(batch.error().kind, Error::Kind::Usage) << batch.error().message;
        continue;
      }
      (void)batch->ask({{"system", own, "answer", "{\"type\":\"object\"}", {}, {}}});
      const auto report = batch->finish();
      EXPECT_TRUE(report && read_file(report->new_files.front()).value().find(own) != std::string::npos)
          << "round " << round << (report ? "" : ": " + report.error().message);
      ++written[which];
    }
  };
  { const std::jthread one(run, 0), other(run, 1); }
  EXPECT_GE(written[0] + written[1], kRounds) << "both were refused";
}

TEST(MadeFolders, AreMadeThoughAnotherRunRemovesThoseAboveMeanwhile) {
  constexpr int kRounds = 200, kSweeps = 20;
  const ScratchFolder folder;
  FolderRemover remover({folder.at("a/b/c"), folder.at("a/b"), folder.at("a")});
  for (int round = 0; round < kRounds; ++round) {
    remover.sweep(kSweeps);
    const auto made = MadeFolders::make(folder.at("a/b/c"));
    ASSERT_TRUE(made) << "round " << round << ": " << made.error().message;
  }
}

}  // namespace
}  // namespace unietp
