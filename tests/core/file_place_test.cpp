// Files inside a folder that a stranger made: no name and no symbolic link leads out of it.
#include "core/file_place.h"

#include <sys/stat.h>

#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/file_digest.h"
#include "core/files.h"
#include "core/limits.h"
#include "core/plain_name.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

TEST(PlainName, IsWhatCanBeAFileAnywhere) {
  for (const char* name : {"ai2thor-00001", "FloorPlan1", "_x", "a.b", "0", "tasks.jsonl", "a..b", "a-"})
    EXPECT_TRUE(is_plain_name(name)) << name;
  EXPECT_TRUE(is_plain_name(std::string(limits::kNameBytes, 'a')));
  EXPECT_FALSE(is_plain_name(std::string(limits::kNameBytes + 1, 'a')));
  using namespace std::string_view_literals;
  for (const auto name : {""sv,        "."sv,   ".."sv,  "../x"sv, "/etc/passwd"sv, "a/b"sv,      "a\\b"sv,
                          ".hidden"sv, "-rf"sv, "a b"sv, "a\nb"sv, "a\0b"sv,        "a\x1b[2J"sv, "k\u00fcche"sv,
                          "\u202ea"sv, "a:b"sv, "a*"sv,  "~"sv,    "a\x7f"sv,       "\xff"sv})
    EXPECT_FALSE(is_plain_name(name)) << name;
}

class FilePlaceTest : public ::testing::Test {
 protected:
  void SetUp() override {
    top_ = fs::temp_directory_path() / ("unietp_place_" + std::to_string(::getpid()) + "_" +
                                        ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(top_);
    fs::create_directories(root_ = top_ / "set");
    fs::create_directories(top_ / "outside");
    std::ofstream(top_ / "outside" / "secret") << "secret";
  }
  void TearDown() override { fs::remove_all(top_); }
  fs::path top_, root_;
};

TEST_F(FilePlaceTest, NoNameLeadsOutOfTheFolder) {
  for (const std::string& name :
       {std::string("../outside/new"), std::string("homes/../../outside/new"), (top_ / "outside" / "new").string(),
        std::string("homes//new"), std::string("homes/"), std::string("./new"), std::string(""), std::string(".."),
        std::string("-new"), std::string("new\n"), std::string("ne\0w", 4), std::string(300, 'n')}) {
    SCOPED_TRACE(name);
    const auto written = write_file(root_, name, "bytes");
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().kind, Error::Kind::Schema);
    EXPECT_FALSE(read_file(root_, name));
    EXPECT_FALSE(digest_of_file(root_, name));
    EXPECT_FALSE(path_inside(root_, name, MissingFolders::Made));
  }
  EXPECT_FALSE(fs::exists(top_ / "outside" / "new"));
  EXPECT_EQ(write_file(root_, "../x", "").error().message,
            "\"..\" names no file of a folder; " + plain_name_expected());
}

TEST_F(FilePlaceTest, NoSymbolicLinkInTheFolderIsFollowed) {
  fs::create_directory_symlink(top_ / "outside", root_ / "homes");
  fs::create_symlink(top_ / "outside" / "secret", root_ / "tasks.jsonl");
  EXPECT_FALSE(write_file(root_, "homes/new", "bytes"));
  EXPECT_FALSE(fs::exists(top_ / "outside" / "new"));
  const auto file = read_file(root_, "tasks.jsonl");
  ASSERT_FALSE(file);
  EXPECT_EQ(format(file.error()), (root_ / "tasks.jsonl").string() +
                                      ": file error: cannot open for reading: is a symbolic link, which is not "
                                      "followed inside a folder");
  const auto folder = read_file(root_, "homes/secret");
  ASSERT_FALSE(folder);
  EXPECT_EQ(format(folder.error()), (root_ / "homes").string() +
                                        ": file error: cannot open this folder: is a symbolic link, which is not "
                                        "followed inside a folder");
  EXPECT_FALSE(digest_of_file(root_, "tasks.jsonl"));
  EXPECT_FALSE(path_inside(root_, "tasks.jsonl", MissingFolders::Refused));
  EXPECT_FALSE(path_inside(root_, "homes/secret", MissingFolders::Refused));
}

TEST_F(FilePlaceTest, WritingReplacesASymbolicLinkAndNotWhatItNames) {
  fs::create_symlink(top_ / "outside" / "secret", root_ / "tasks.jsonl");
  fs::create_symlink(top_ / "outside" / "secret", root_ / "tasks.jsonl.tmp");
  ASSERT_TRUE(write_file(root_, "tasks.jsonl", "bytes"));
  EXPECT_EQ(*read_file(top_ / "outside" / "secret"), "secret");
  EXPECT_EQ(*read_file(root_, "tasks.jsonl"), "bytes");
}

TEST_F(FilePlaceTest, TheFolderItselfMayBeASymbolicLinkAndIsMadeWhenItMayBe) {
  fs::create_directory_symlink(root_, top_ / "link");
  ASSERT_TRUE(write_file(top_ / "link", "homes/a.json", "bytes"));
  EXPECT_EQ(*read_file(root_, "homes/a.json"), "bytes");
  EXPECT_EQ(*path_inside(top_ / "link", "homes/a.json", MissingFolders::Refused),
            fs::canonical(root_) / "homes/a.json");
  EXPECT_FALSE(place_inside(top_ / "none", "a", MissingFolders::Refused));
  ASSERT_TRUE(write_file(top_ / "none" / "new", "a/b/c", "bytes"));
  EXPECT_EQ(*read_file(top_ / "none" / "new", "a/b/c"), "bytes");
}

/// What each way of reading says of a path that is no regular file.
void expect_refused(const fs::path& root, const std::string& name, const std::string& message) {
  SCOPED_TRACE(name);
  for (const auto& read : {read_file(root / name), read_file(root, name)}) {
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().message, message);
  }
  EXPECT_FALSE(digest_of_file(root / name));
}

TEST_F(FilePlaceTest, NothingButARegularFileIsReadAndNothingIsWaitedFor) {
  ASSERT_EQ(::mkfifo((root_ / "fifo").c_str(), 0600), 0);
  fs::create_directory(root_ / "folder");
  expect_refused(root_, "fifo", "is a FIFO; expected a file");
  expect_refused(root_, "folder", "is a folder; expected a file");
  EXPECT_EQ(read_file("/dev/zero").error().message, "is a device; expected a file");
  EXPECT_EQ(read_file("/dev", "zero").error().message, "is a device; expected a file");
  fs::create_symlink(root_ / "loop", root_ / "loop");
  EXPECT_EQ(read_file(root_ / "loop").error().message, "cannot open for reading: Too many levels of symbolic links");
}

TEST_F(FilePlaceTest, AFileBeyondTheBoundIsRefusedWithoutItsMemory) {
  std::ofstream(root_ / "large") << "x";
  fs::resize_file(root_ / "large", std::uintmax_t{1} << 40);  // sparse
  const auto read = read_file(root_ / "large");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().message, "has more than 268435456 bytes, the most that a file may have");
}

}  // namespace
}  // namespace unietp
