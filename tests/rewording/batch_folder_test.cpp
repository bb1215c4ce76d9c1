#include "rewording/batch_folder.h"

#include <gmock/gmock.h>

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

}  // namespace
}  // namespace unietp
