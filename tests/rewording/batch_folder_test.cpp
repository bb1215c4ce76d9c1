#include "rewording/batch_folder.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "core/files.h"
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

}  // namespace
}  // namespace unietp
