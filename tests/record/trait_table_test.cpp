#include "record/trait_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

std::filesystem::path database(const char* rows) {
  const auto file = std::filesystem::path(::testing::TempDir()) /
                    (std::string("traits_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
  std::filesystem::remove(file);
  SqliteFile written(file, SqliteFile::Mode::Create);
  written.run("CREATE TABLE task(id TEXT PRIMARY KEY); CREATE TABLE trait(task TEXT, dimension TEXT, value TEXT);");
  written.run(rows);
  return file;
}

TEST(TraitTable, GivesEachTaskItsOwnWhateverTheirOrder) {
  auto table = TraitTable::open(
      database("INSERT INTO task VALUES('a'),('b'),('c'); INSERT INTO trait VALUES('c','room','kitchen'),"
               "('a','scene','home'),('x','room','bath'),('a','room','hall');"));
  ASSERT_TRUE(table) << format(table.error());
  EXPECT_THAT(*table->of(1, "a"), ElementsAre(Pair("scene", "home"), Pair("room", "hall")));
  EXPECT_THAT(*table->of(2, "b"), IsEmpty());
  EXPECT_THAT(*table->of(3, "another"), IsEmpty());
}

TEST(TraitTable, CountsTheTasksOfEachValue) {
  const auto counts = trait_counts(database("INSERT INTO trait VALUES('a','room','hall'),('b','room','hall');"));
  ASSERT_TRUE(counts) << format(counts.error());
  EXPECT_EQ(*counts, (TraitCounts{{"room", {{"hall", 2}}}}));
}

TEST(TraitTable, AFileThatIsNoDatabaseIsAnError) {
  const auto file = database("DROP TABLE trait;");
  EXPECT_FALSE(TraitTable::open(file));
  EXPECT_FALSE(trait_counts(file));
}

}  // namespace
}  // namespace unietp
