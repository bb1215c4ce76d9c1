// Files are written wholly or not at all, and who wrote them is told so.
#include "core/file_writer.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <thread>

#include "core/files.h"
#include "core/sqlite_file.h"
#include "tests/support/refused_calls.h"
#include "tests/support/scratch_folder.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

TEST(FileWriter, WritesWhatWasAddedHoweverMuch) {
  const ScratchFolder folder;
  auto file = FileWriter::begin(folder.at("x"));
  ASSERT_TRUE(file);
  std::string all;
  for (int i = 0; i < 300; ++i) {
    const std::string part(static_cast<std::size_t>(i * 7), static_cast<char>('a' + i % 26));
    all += part;
    ASSERT_TRUE(file->add(part));
  }
  ASSERT_TRUE(file->finish());
  EXPECT_EQ(*read_file(folder.at("x")), all);
}

TEST(FileWriter, AnOlderLongerFileLeavesNothingBehind) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.at("x"), "a long old file"));
  auto file = FileWriter::begin(folder.at("x"));
  ASSERT_TRUE(file && file->add("new") && file->finish());
  EXPECT_EQ(*read_file(folder.at("x")), "new");
}

// The last bytes of a small file are written when it is closed; a full disk or a network may refuse them then.
TEST(FileWriter, ARefusedCloseIsAnError) {
  const ScratchFolder folder;
  for (const bool replacing : {false, true}) {
    auto place = place_of(folder.at("x"));
    ASSERT_TRUE(place);
    auto file = replacing ? FileWriter::replace(std::move(*place)) : FileWriter::begin(folder.at("y"));
    ASSERT_TRUE(file && file->add("bytes"));
    const RefusedClose refused(replacing ? "x.tmp" : "y");
    const auto finished = file->finish();
    ASSERT_FALSE(finished);
    EXPECT_EQ(finished.error().kind, Error::Kind::Io);
    EXPECT_THAT(finished.error().message, HasSubstr("No space left"));
    EXPECT_FALSE(fs::exists(folder.at("x")));
  }
}

TEST(FileWriter, AnotherNameOfTheFileKeepsItsBytes) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.at("mine"), "mine"));
  fs::create_hard_link(folder.at("mine"), folder.at("same"));
  fs::create_symlink("mine", folder.at("link.tmp"));
  auto file = FileWriter::begin(folder.at("same"));
  ASSERT_TRUE(file && file->add("other") && file->finish());
  ASSERT_TRUE(write_file(folder.at("link"), "other"));
  EXPECT_EQ(*read_file(folder.at("mine")), "mine");
  EXPECT_EQ(*read_file(folder.at("same")), "other");
  EXPECT_EQ(*read_file(folder.at("link")), "other");
}

TEST(WriteFile, AfterARefusedCloseTheOldFileStandsAndNothingElse) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.at("x"), "old"));
  {
    const RefusedClose refused("x.tmp");
    const auto failed = write_file(folder.at("x"), "new");
    ASSERT_FALSE(failed);
    EXPECT_EQ(failed.error().where, folder.at("x"));
  }
  EXPECT_EQ(*read_file(folder.at("x")), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(WriteFile, ADiskThatIsFullAfterAnyNumberOfBytesKeepsTheOldFile) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.at("x"), "old"));
  const std::string bytes(50, 'n');
  for (unsigned long room = 0; room < bytes.size(); ++room) {
    Result<Done> failed = Done{};
    {
      const RefusedGrowth refused(room);
      failed = write_file(folder.at("x"), bytes);
    }
    ASSERT_FALSE(failed) << room;
    EXPECT_THAT(failed.error().message, HasSubstr("cannot write")) << room;
    ASSERT_EQ(*read_file(folder.at("x")), "old") << room;
    ASSERT_FALSE(fs::exists(folder.at("x.tmp"))) << room;
  }
  const RefusedGrowth refused(bytes.size());
  EXPECT_TRUE(write_file(folder.at("x"), bytes));
}

TEST(WriteFile, ATemporaryOfAKilledProcessIsNoObstacle) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.at("x.tmp"), "half of something longer"));
  ASSERT_TRUE(write_file(folder.at("x"), "new"));
  EXPECT_EQ(*read_file(folder.at("x")), "new");
  EXPECT_FALSE(fs::exists(folder.at("x.tmp")));
}

TEST(WriteFile, ManyWritersOfOneFileAllSucceedAndReadersSeeWholeFiles) {
  const ScratchFolder folder;
  constexpr int kWriters = 4, kTimes = 50;
  const auto whole = [](char letter) { return std::string(100'000, letter); };
  ASSERT_TRUE(write_file(folder.at("x"), whole('a')));
  std::vector<std::thread> writers;
  std::vector<std::string> failures(kWriters);
  for (int w = 0; w < kWriters; ++w) {
    writers.emplace_back([&, w] {
      for (int i = 0; i < kTimes; ++i) {
        if (const auto written = write_file(folder.at("x"), whole(static_cast<char>('a' + w))); !written)
          failures[static_cast<std::size_t>(w)] = format(written.error());
      }
    });
  }
  for (int i = 0; i < kTimes; ++i) {
    const auto read = read_file(folder.at("x"));
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, whole(read->front()));
  }
  for (auto& writer : writers) writer.join();
  for (const auto& failure : failures) EXPECT_EQ(failure, "");
  const auto last = read_file(folder.at("x"));
  ASSERT_TRUE(last);
  EXPECT_EQ(*last, whole(last->front()));
  EXPECT_FALSE(fs::exists(folder.at("x.tmp")));
}

TEST(WriteFile, ALinkStaysAndWhatItLeadsToIsReplaced) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.at("target"), "old"));
  fs::create_symlink("target", folder.at("link"));
  ASSERT_TRUE(write_file(folder.at("link"), "new"));
  EXPECT_TRUE(fs::is_symlink(folder.at("link")));
  EXPECT_EQ(*read_file(folder.at("target")), "new");
}

TEST(WriteFile, APipeIsWrittenToAndStaysAPipe) {
  const ScratchFolder folder;
  ASSERT_EQ(::mkfifo(folder.at("pipe").c_str(), 0600), 0);
  const int reader = ::open(folder.at("pipe").c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  EXPECT_TRUE(write_file(folder.at("pipe"), "bytes"));
  std::array<char, 16> read{};
  EXPECT_EQ(::read(reader, read.data(), read.size()), 5);
  ::close(reader);
  EXPECT_TRUE(fs::is_fifo(folder.at("pipe")));
}

TEST(CheckWritable, FindsWhatWriteFileWouldAndLeavesNothing) {
  const ScratchFolder folder;
  EXPECT_TRUE(check_writable(folder.at("new")));
  EXPECT_TRUE(check_writable(folder.path() / "deep" / "er" / "new"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 0);
  ASSERT_TRUE(write_file(folder.at("file"), "bytes"));
  EXPECT_TRUE(check_writable(folder.at("file")));
  EXPECT_EQ(*read_file(folder.at("file")), "bytes");
  for (const auto& bad : {folder.path() / "file" / "below", folder.path(), fs::path("/proc/unietp/file")}) {
    const auto refused = check_writable(bad);
    ASSERT_FALSE(refused) << bad;
    EXPECT_EQ(refused.error().where, bad.string());
  }
  EXPECT_TRUE(check_writable("relative-file"));
  EXPECT_FALSE(fs::exists("relative-file.tmp"));
}

TEST(ConfirmWritten, ARefusedCloseIsAnErrorAlsoOfAFileThatSqliteWrote) {
  const ScratchFolder folder;
  {
    SqliteFile file(folder.at("a.sqlite"), SqliteFile::Mode::Create);
    file.run("CREATE TABLE t(x)");
  }
  EXPECT_TRUE(confirm_written(folder.at("a.sqlite")));
  EXPECT_FALSE(confirm_written(folder.at("none")));
  const RefusedClose refused("a.sqlite");
  EXPECT_FALSE(confirm_written(folder.at("a.sqlite")));
}

}  // namespace
}  // namespace unietp
