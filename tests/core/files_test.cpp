#include "core/files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/digest.h"
#include "core/file_digest.h"
#include "core/rng.h"
#include "tests/support/scratch_folder.h"

namespace unietp {
namespace {

class Files : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::temp_directory_path() / ("unietp_files_" + std::to_string(::getpid()) + "_" +
                                                  ::testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path folder_;
};

TEST_F(Files, WhatIsWrittenIsReadAndFoldersAreMade) {
  const auto path = folder_ / "deep" / "er" / "file.txt";
  const std::string bytes("a\0b\n", 4);
  ASSERT_TRUE(write_file(path, bytes));
  EXPECT_EQ(*read_file(path), bytes);
  ASSERT_TRUE(write_file(path, ""));
  EXPECT_EQ(*read_file(path), "");
}

TEST_F(Files, WritingLeavesNoTemporaryBehind) {
  ASSERT_TRUE(write_file(folder_ / "x", "old"));
  ASSERT_TRUE(write_file(folder_ / "x", "new"));
  EXPECT_EQ(*read_file(folder_ / "x"), "new");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

// A reader that opened the old file keeps the old bytes: the new ones come by renaming, not by overwriting.
TEST_F(Files, WritingReplacesTheFileWhole) {
  ASSERT_TRUE(write_file(folder_ / "x", "old bytes"));
  std::filesystem::create_hard_link(folder_ / "x", folder_ / "reader");
  ASSERT_TRUE(write_file(folder_ / "x", "new"));
  EXPECT_EQ(*read_file(folder_ / "reader"), "old bytes");
}

TEST_F(Files, AFailedWriteKeepsTheOldFileAndRemovesItsTemporary) {
  ASSERT_TRUE(std::filesystem::create_directories(folder_ / "target" / "full"));
  const auto failed = write_file(folder_ / "target", "bytes");  // a folder that is not empty cannot be replaced
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().kind, Error::Kind::Io);
  EXPECT_EQ(failed.error().where, (folder_ / "target").string());
  EXPECT_FALSE(std::filesystem::exists(folder_ / "target.tmp"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "target" / "full"));
}

TEST_F(Files, AFolderThatCannotBeMadeIsAnError) {
  ASSERT_TRUE(write_file(folder_ / "file", "not a folder"));
  const auto failed = write_file(folder_ / "file" / "below", "bytes");
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().kind, Error::Kind::Io);
}

TEST_F(Files, AnUnwritableFolderIsAnError) {
  const auto locked = folder_ / "locked";
  std::filesystem::create_directories(locked);
  std::filesystem::permissions(locked, std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  if (::geteuid() == 0) {
    // Permissions do not bind the superuser; a folder of the kernel's does.
    const auto failed = write_file("/proc/unietp/file", "bytes");
    ASSERT_FALSE(failed);
    EXPECT_EQ(failed.error().kind, Error::Kind::Io);
  } else {
    const auto failed = write_file(locked / "file", "bytes");
    ASSERT_FALSE(failed);
    EXPECT_EQ(format(failed.error()),
              (locked / "file").string() + ": file error: cannot open for writing: Permission denied");
  }
}

TEST_F(Files, ReadingNamesWhatIsMissing) {
  const auto missing = read_file(folder_ / "none");
  ASSERT_FALSE(missing);
  EXPECT_EQ(format(missing.error()),
            (folder_ / "none").string() + ": file error: cannot open for reading: No such file or directory");
  const auto folder = read_file(folder_);
  ASSERT_FALSE(folder);
  EXPECT_EQ(folder.error().message, "is a folder; expected a file");
}

TEST_F(Files, GzipIsUndoneByGunzipAndByReadingAGzFile) {
  Rng rng(7);
  for (const std::size_t size : {0UL, 1UL, 1000UL, 200000UL}) {
    std::string bytes;
    for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(rng.below(size < 5000 ? 256 : 4));
    const std::string packed = gzip(bytes);
    EXPECT_EQ(packed, gzip(bytes));
    EXPECT_EQ(*gunzip("x", packed), bytes);
    ASSERT_TRUE(write_file(folder_ / "x.gz", packed));
    EXPECT_EQ(*read_maybe_gzip(folder_ / "x.gz"), bytes);
    ASSERT_TRUE(write_file(folder_ / "x.txt", bytes));
    EXPECT_EQ(*read_maybe_gzip(folder_ / "x.txt"), bytes);
  }
}

TEST(Gunzip, RefusesWhatIsCutCorruptOrTooLarge) {
  const std::string packed = gzip(std::string(100000, 'a'));
  for (const std::string& bad : {std::string("no gzip"), std::string(), packed.substr(0, packed.size() / 2)}) {
    const auto result = gunzip("f.gz", bad);
    ASSERT_FALSE(result);
    EXPECT_EQ(format(result.error()), "f.gz: parse error: not a whole gzip file");
  }
  const auto large = gunzip("f.gz", packed, 1000);
  ASSERT_FALSE(large);
  EXPECT_EQ(large.error().message, "unpacks to more than 1000 bytes");
  EXPECT_FALSE(gunzip("f.gz", packed + "more"));
}

TEST(Gunzip, ReadsMembersInARowAsOneFile) {
  const std::string first(300000, 'a'), second = "and the end";
  EXPECT_EQ(*gunzip("f.gz", gzip(first) + gzip(second)), first + second);
  EXPECT_EQ(*gunzip("f.gz", gzip(first) + gzip("") + gzip(second), first.size() + second.size()), first + second);
  EXPECT_FALSE(gunzip("f.gz", gzip(first) + gzip(second), first.size() + second.size() - 1));
}

TEST(DigestOfFile, IsThatOfItsBytes) {
  const auto file = std::filesystem::path(::testing::TempDir()) / "digested";
  for (const std::size_t size : {std::size_t{0}, std::size_t{3}, std::size_t{1} << 18, (std::size_t{1} << 19) + 1}) {
    const std::string bytes(size, 'x');
    ASSERT_TRUE(write_file(file, bytes));
    const auto digest = digest_of_file(file);
    ASSERT_TRUE(digest) << format(digest.error());
    EXPECT_EQ(digest->bytes, size);
    EXPECT_EQ(digest->sha256, sha256(bytes));
  }
  EXPECT_FALSE(digest_of_file(file / "nothing"));
}

TEST(DigestOfFile, ReadsNothingOfAFileOfAnotherLength) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.path() / "huge", "abc"));
  const auto digest = digest_of_file(folder.path(), "huge", 3);
  ASSERT_TRUE(digest) << format(digest.error());
  EXPECT_EQ(digest->sha256, sha256("abc"));
  constexpr std::uintmax_t kTerabyte = std::uintmax_t{1} << 40;  // with a hole, so that it takes no room
  std::filesystem::resize_file(folder.path() / "huge", kTerabyte);
  const auto other = digest_of_file(folder.path(), "huge", 3);
  ASSERT_TRUE(other) << format(other.error());
  EXPECT_EQ(other->bytes, kTerabyte);
  EXPECT_EQ(other->sha256, "");
}

}  // namespace
}  // namespace unietp
