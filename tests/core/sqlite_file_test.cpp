#include "core/sqlite_file.h"

#include <filesystem>
#include <optional>
#include <stdexcept>

#include <gtest/gtest.h>
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

}  // namespace
}  // namespace unietp
