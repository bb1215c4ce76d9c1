#include "validator/file_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/digest.h"
#include "core/files.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class CheckedFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) /
              (std::string("files_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    write("a.txt", "alpha");
    write("manifest.json", "{}");
    manifest_.files["a.txt"] = {sha256("alpha"), 5};
  }
  void TearDown() override { fs::remove_all(folder_); }
  void write(const std::string& name, const std::string& bytes) { ASSERT_TRUE(write_file(folder_ / name, bytes)); }
  std::vector<std::string> found() const {
    const FileCheck check(folder_, manifest_);
    auto problems = check.listing();
    for (const auto& file : check.files()) append(problems, check.of(file));
    std::vector<std::string> texts;
    for (const auto& problem : problems)
      texts.push_back(std::string(name_of(problem.kind)) + " " + problem.error.where);
    return texts;
  }
  fs::path folder_;
  ManifestRecord manifest_;
};

TEST_F(CheckedFolder, ASoundOneHasNoProblems) { EXPECT_THAT(found(), IsEmpty()); }
TEST_F(CheckedFolder, ChangedBytesAreNamed) {
  write("a.txt", "alphb");
  EXPECT_THAT(found(), ElementsAre("changed-file a.txt"));
}
TEST_F(CheckedFolder, AnotherLengthIsNamed) {
  write("a.txt", "alphabet");
  EXPECT_THAT(found(), ElementsAre("changed-file a.txt"));
}
TEST_F(CheckedFolder, AMissingFileIsNamed) {
  fs::remove(folder_ / "a.txt");
  EXPECT_THAT(found(), ElementsAre("missing-file a.txt"));
}
TEST_F(CheckedFolder, ASurplusFileIsNamed) {
  write("deep/b.txt", "beta");
  EXPECT_THAT(found(), ElementsAre("unlisted-file deep/b.txt"));
}

}  // namespace
}  // namespace unietp
