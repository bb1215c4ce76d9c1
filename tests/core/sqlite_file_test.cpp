#include "core/sqlite_file.h"

#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

namespace unietp {
namespace {

struct SqliteFiles : ::testing::Test {
  SqliteFiles() { std::filesystem::remove(path); }
  ~SqliteFiles() override { std::filesystem::remove(path); }
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("unietp-sqlite-file-" + std::to_string(::getpid()));
};

TEST_F(SqliteFiles, GiveAStatementAgainAsIfItWereNew) {
  SqliteFile file(path, SqliteFile::Mode::Create);
  file.run("create table thing (name text, size real)");
  for (const char* name : {"mug", "plate", "pan"}) {
    Statement insert = file.prepare("insert into thing values (?, ?)");
    insert.bind(1, std::string_view(name));
    if (name[0] == 'm') insert.bind(2, 0.5);  // the others have none, whatever the one before had
    insert.step();
  }
  for (int again = 0; again < 2; ++again) {
    Statement all = file.prepare("select name, size from thing order by name");
    Statement same = file.prepare("select name, size from thing order by name");  // while the first is in use
    ASSERT_TRUE(all.step());
    EXPECT_EQ(all.text(0), "mug");
    EXPECT_EQ(all.number(1), 0.5);
    ASSERT_TRUE(same.step());
    ASSERT_TRUE(all.step());
    EXPECT_EQ(all.text(0), "pan");
    EXPECT_EQ(all.text(1), "");
    EXPECT_EQ(same.text(0), "mug");
  }  // left in the middle of the rows
  file.run("begin");
  file.run("delete from thing");
  file.run("commit");
  EXPECT_FALSE(file.prepare("select name, size from thing order by name").step());
}

TEST_F(SqliteFiles, CloseWithStatementsThatNobodyUses) {
  std::optional<SqliteFile> file(std::in_place, path, SqliteFile::Mode::Create);
  file->run("create table thing (name text)");
  file->prepare("insert into thing values ('mug')").step();
  *file = SqliteFile(path, SqliteFile::Mode::Read);
  EXPECT_TRUE(file->prepare("select * from thing").step());
  EXPECT_THROW(file->prepare("insert into thing values ('pan')").step(), std::runtime_error);
  EXPECT_THROW(file->prepare("select * from nothing"), std::runtime_error);
  file.reset();
  std::filesystem::remove(path);
  EXPECT_THROW(SqliteFile(path, SqliteFile::Mode::Read).prepare("select * from thing"), std::runtime_error);
}

TEST_F(SqliteFiles, RunNothingThatTheSchemaBrings) {
  {
    SqliteFile file(path, SqliteFile::Mode::Create);
    file.run(
        "create table thing (name text); create table told (name text);"
        "create view endless as with recursive n(x) as (select 1 union all select x + 1 from n) select x from n;"
        "create trigger tell after insert on thing begin insert into told values (new.name); end;"
        "insert into thing values ('mug')");
    EXPECT_FALSE(file.prepare("select * from told").step());
  }
  SqliteFile file(path, SqliteFile::Mode::Read);
  EXPECT_TRUE(file.prepare("select * from thing").step());
  EXPECT_THROW(file.prepare("select count(*) from endless"), std::runtime_error);
}

TEST_F(SqliteFiles, ReadNoValueThatWouldFillTheMemory) {
  SqliteFile file(path, SqliteFile::Mode::Create);
  file.run("create table thing (name text); insert into thing values ('mug')");
  file.run("alter table thing add column long as (zeroblob(900000000))");
  EXPECT_TRUE(file.prepare("select name from thing").step());
  EXPECT_THROW(file.prepare("select long from thing").step(), std::runtime_error);
}

TEST_F(SqliteFiles, AreNotWaitedForWhenTheyAreFifos) {
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  EXPECT_THROW(SqliteFile(path, SqliteFile::Mode::Read), std::runtime_error);
  EXPECT_THROW(SqliteFile(path, SqliteFile::Mode::Create), std::runtime_error);
}

TEST_F(SqliteFiles, AreReadUnderAnyNameAndWithoutTheJournalBesideThem) {
  const auto odd = path.parent_path() / (path.filename().string() + " 100%?#&\xc3\xa4");
  const auto journal = std::filesystem::path(odd.string() + "-journal");
  SqliteFile(odd, SqliteFile::Mode::Create).run("create table thing (name text); insert into thing values ('mug')");
  std::ofstream(journal) << "what a stranger put there";
  EXPECT_TRUE(SqliteFile(odd, SqliteFile::Mode::Read).prepare("select * from thing").step());
  EXPECT_TRUE(std::filesystem::remove(journal));
  EXPECT_TRUE(std::filesystem::remove(odd));
}

}  // namespace
}  // namespace unietp
