#include "validator/manifest_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/digest.h"
#include "core/files.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class DataFolder : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              (std::string("manifest_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    write("a.txt", "alpha");
    manifest("digest", sha256("alpha"));
  }
  void TearDown() override { fs::remove_all(folder_); }
  void write(const std::string& name, const std::string& bytes) { ASSERT_TRUE(write_file(folder_ / name, bytes)); }
  void manifest(const std::string& knowledge, const std::string& digest) {
    write("manifest.json", R"({"format":"unietp-manifest/1","program":{},"knowledge_digest":")" + knowledge +
                               R"(","seed":1,"configuration":{},"counts":{"tasks":3},"files":[{"path":"a.txt",)"
                               R"("bytes":5,"sha256":")" +
                               digest + R"("}],"sources":[]})");
  }
  void expect_one(const std::string& where, const std::string& words) {
    const auto check = check_manifest(folder_, "digest");
    ASSERT_EQ(check.errors.size(), 1U);
    EXPECT_THAT(check.errors[0].where, HasSubstr(where));
    EXPECT_THAT(check.errors[0].message, HasSubstr(words));
  }
  fs::path folder_;
};

TEST_F(DataFolder, ASoundOneHasNoErrors) {
  const auto check = check_manifest(folder_, "digest");
  EXPECT_TRUE(check.errors.empty());
  EXPECT_EQ(check.tasks, 3);
}
TEST_F(DataFolder, ChangedBytesAreNamed) {
  write("a.txt", "alphb");
  expect_one("a.txt", "SHA-256");
}
TEST_F(DataFolder, AMissingFileIsNamed) {
  fs::remove(folder_ / "a.txt");
  expect_one("a.txt", "missing");
}
TEST_F(DataFolder, ASurplusFileIsNamed) {
  write("deep/b.txt", "beta");
  expect_one("deep/b.txt", "not listed");
}
TEST_F(DataFolder, OtherKnowledgeIsNamed) {
  manifest("another", sha256("alpha"));
  expect_one("manifest.json", "--data");
}
TEST_F(DataFolder, ABrokenOrMissingManifestIsAnError) {
  write("manifest.json", "{");
  expect_one("manifest.json", "");
  fs::remove(folder_ / "manifest.json");
  expect_one("manifest.json", "");
}

}  // namespace
}  // namespace unietp
