// A data set is finished only when every one of its files is: what a file system refuses as late as on closing is told.
#include "dataset/dataset_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "tests/support/refused_calls.h"
#include "tests/support/scratch_folder.h"

namespace unietp {
namespace {

using ::testing::HasSubstr;

TEST(DatasetWriter, ARefusedCloseOfAnyFileIsAnError) {
  for (const char* file : {"tasks.jsonl", "rejections.jsonl", "demonstrations/M1.jsonl", "dataset.sqlite"}) {
    SCOPED_TRACE(file);
    const ScratchFolder folder;
    auto writer = DatasetWriter::begin(folder.path() / "data");
    ASSERT_TRUE(writer);
    ASSERT_TRUE(writer->add_rejection({3, 1, "open-one", "ai2thor", "atomic", "expert", "no-plan", ""}));
    const RefusedClose refused(std::string("data/") + file);
    const auto finished = writer->finish({}, {}, {});
    ASSERT_FALSE(finished);
    EXPECT_EQ(finished.error().kind, Error::Kind::Io);
    EXPECT_THAT(finished.error().where, HasSubstr(file));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "data" / "manifest.json"));
  }
}

TEST(DatasetWriter, ADiskThatIsFullIsAnErrorAtTheLatestWhenAFileIsFinished) {
  const ScratchFolder folder;
  auto lines = LinesWriter::begin(folder.path() / "tasks.jsonl");
  ASSERT_TRUE(lines);
  const RefusedGrowth refused(10);
  const auto added = lines->add("a line of more than ten bytes");
  EXPECT_FALSE(added && lines->finish());
}

}  // namespace
}  // namespace unietp
