#include "resources/find_data_folder.h"

#include <gtest/gtest.h>

#include <unistd.h>

namespace unietp {
namespace {

namespace fs = std::filesystem;

class DataFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::path(::testing::TempDir()) / ("unietp-data-folder-" + std::to_string(::getpid()));
    fs::remove_all(root_);
    fs::create_directories(root_);
  }
  void TearDown() override { fs::remove_all(root_); }
  fs::path with_data(const std::string& name) {
    fs::create_directories(root_ / name / "data" / "akb");
    fs::create_directories(root_ / name / "templates" / "library");
    return root_ / name;
  }
  fs::path root_;
};

TEST_F(DataFolder, OfAnInstallationIsBesideTheProgram) {
  const auto installed = with_data("usr/share/unietp");
  const auto found = find_data_folder(root_ / "usr" / "bin" / "unietp", "");
  ASSERT_TRUE(found);
  EXPECT_EQ(*found, installed);
}

TEST_F(DataFolder, OfABuildIsTheCheckoutAboveTheProgram) {
  const auto checkout = with_data("checkout");
  with_data(".");  // a folder farther up must not win
  const auto found = find_data_folder(checkout / "build" / "release" / "bin" / "unietp", "");
  ASSERT_TRUE(found);
  EXPECT_EQ(*found, checkout);
}

TEST_F(DataFolder, TheVariableWinsOverBoth) {
  with_data("usr/share/unietp");
  const auto own = with_data("own");
  const auto found = find_data_folder(root_ / "usr" / "bin" / "unietp", own.string());
  ASSERT_TRUE(found);
  EXPECT_EQ(*found, own);
}

TEST_F(DataFolder, AVariableThatNamesNoDataIsAnErrorAndNotIgnored) {
  with_data("usr/share/unietp");
  const auto found = find_data_folder(root_ / "usr" / "bin" / "unietp", (root_ / "nowhere").string());
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().where, "UNIETP_DATA");
}

TEST_F(DataFolder, NoneIsAnErrorThatSaysWhatToGive) {
  const auto found = find_data_folder("/usr/bin/unietp-that-is-nowhere", "");
  ASSERT_FALSE(found);
  EXPECT_NE(found.error().message.find("UNIETP_DATA"), std::string::npos);
}

}  // namespace
}  // namespace unietp
