#include <cctype>

#include <gtest/gtest.h>

#include "akb/csv.h"
#include "core/files.h"
#include "core/text.h"
#include "tests/akb/small_tables.h"
#include "tests/support/sqlite_client.h"

namespace unietp {
namespace {

std::string bytes_of(const std::filesystem::path& path) {
  const auto bytes = read_file(path);
  EXPECT_TRUE(bytes);
  return bytes ? *bytes : std::string();
}

/// The tables of a loaded knowledge base as CSV, without what lay_kinds and lay_phrases add: equal text means every
/// field is equal.
std::string all_text(const Knowledge& k) {
  Tables tables{k.categories(), k.affordances(), k.placements(), k.effects(), k.aliases(), k.assets()};
  std::erase_if(tables.aliases, [](const Alias& alias) {
    const bool phrase = alias.kind == AliasKind::Hypernym || alias.kind == AliasKind::Description ||
                        alias.kind == AliasKind::Occasion || alias.kind == AliasKind::Request;
    return phrase || alias.source.source.starts_with("derived:function:");
  });
  std::string text;
  for (const auto& table : table_names()) text += table_csv(tables, table);
  return text;
}

TEST(CompileKnowledge, LoadGivesExactlyWhatTheCommittedTablesSay) {
  const ScratchFolder folder;
  const auto database = folder.path() / "knowledge.sqlite";
  const auto errors = compile_knowledge(test::committed_tables(), database);
  ASSERT_TRUE(errors.empty()) << format(errors.front());
  for (const auto simulator : kSimulators) {
    SCOPED_TRACE(name_of(simulator));
    const auto knowledge = load_knowledge(database, simulator);
    ASSERT_TRUE(knowledge) << format(knowledge.error());
    EXPECT_EQ(knowledge->simulator(), simulator);
    auto tables = test::committed(simulator);
    sort_tables(tables);
    std::string expected;
    for (const auto& table : table_names()) expected += table_csv(tables, table);
    // Line by line: gtest would compare the whole texts with one another, which takes more memory than there is.
    const auto found = split(all_text(*knowledge), '\n'), wanted = split(expected, '\n');
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) ASSERT_EQ(found[i], wanted[i]);
  }
}

/// A view of the database as the CSV text of a simulator's table.
std::string view_text(test::SqliteClient& database, const std::string& table, Simulator simulator) {
  const auto& columns = columns_of(table);
  std::string text = csv_line(columns);
  for (const auto& row : database.rows("SELECT " + join(columns, ",") + " FROM " + table + " WHERE simulator = '" +
                                       std::string(name_of(simulator)) + "'")) {
    std::vector<std::string> fields;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const std::string& cell = row.at(i);
      const bool flag = columns[i] == "countable" || columns[i] == "movable";
      const bool number = std::isdigit(static_cast<unsigned char>(cell[0])) != 0 && cell.find('.') != std::string::npos;
      fields.push_back(flag ? (cell == "1" ? "true" : "false") : number ? number_text(std::stod(cell)) : cell);
    }
    text += csv_line(fields);
  }
  return text;
}

TEST(CompileKnowledge, TheViewsSayWhatTheTablesSay) {
  const ScratchFolder folder;
  test::write_small_tables(folder.path() / "t", test::small_tables());
  ASSERT_TRUE(compile_knowledge(folder.path() / "t", folder.path() / "k.sqlite").empty());
  test::SqliteClient database(folder.path() / "k.sqlite");
  const auto k = test::small_knowledge();
  const Tables tables{k.categories(), k.affordances(), k.placements(), k.effects(), k.aliases(), k.assets()};
  for (const auto& table : table_names())
    EXPECT_EQ(view_text(database, table, Simulator::Virtualhome), table_csv(tables, table));
}

TEST(CompileKnowledge, EqualTablesGiveEqualBytes) {
  const ScratchFolder folder;
  test::write_small_tables(folder.path() / "t", test::small_tables());
  ASSERT_TRUE(compile_knowledge(folder.path() / "t", folder.path() / "a.sqlite").empty());
  ASSERT_TRUE(compile_knowledge(folder.path() / "t", folder.path() / "b.sqlite").empty());
  EXPECT_EQ(bytes_of(folder.path() / "a.sqlite"), bytes_of(folder.path() / "b.sqlite"));
}

TEST(CompileKnowledge, LeavesTheOldDatabaseAloneWhenATableIsBad) {
  const ScratchFolder folder;
  const auto tables = folder.path() / "t", database = folder.path() / "k.sqlite";
  auto texts = test::small_tables();
  test::write_small_tables(tables, texts);
  ASSERT_TRUE(compile_knowledge(tables, database).empty());
  const auto before = bytes_of(database);
  texts["affordance"] += "mug,flyable,curated,1\n";
  test::write_small_tables(tables, texts);
  EXPECT_FALSE(compile_knowledge(tables, database).empty());
  EXPECT_EQ(bytes_of(database), before);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "k.sqlite.tmp"));
}

TEST(CompileKnowledge, ReportsADatabaseThatCannotBeWritten) {
  const ScratchFolder folder;
  test::write_small_tables(folder.path() / "t", test::small_tables());
  ASSERT_TRUE(write_file(folder.path() / "file", "x"));
  const auto errors = compile_knowledge(folder.path() / "t", folder.path() / "file" / "k.sqlite");
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors.front().kind, Error::Kind::Io);
}

TEST(CompileKnowledge, ReplacesWhatAKilledRunLeftBehind) {
  const ScratchFolder folder;
  test::write_small_tables(folder.path() / "t", test::small_tables());
  ASSERT_TRUE(write_file(folder.path() / "k.sqlite.tmp", "half a database"));
  EXPECT_TRUE(compile_knowledge(folder.path() / "t", folder.path() / "k.sqlite").empty());
  EXPECT_TRUE(load_knowledge(folder.path() / "k.sqlite", Simulator::Habitat));
}

TEST(KnowledgeDigest, IsStoredAndChangesWithAnyByteOfAnyTable) {
  const ScratchFolder folder;
  const auto tables = folder.path() / "t", database = folder.path() / "k.sqlite";
  test::write_small_tables(tables, test::small_tables());
  ASSERT_TRUE(compile_knowledge(tables, database).empty());
  const auto digest = digest_of_tables(tables);
  const auto stored = digest_of_database(database);
  ASSERT_TRUE(digest);
  ASSERT_TRUE(stored) << format(stored.error());
  EXPECT_EQ(*digest, *stored);
  for (const auto simulator : kSimulators) {
    for (const auto& table : table_names()) {
      const auto path = tables / std::string(name_of(simulator)) / (table + ".csv");
      const auto text = bytes_of(path);
      ASSERT_TRUE(write_file(path, text + "\n"));
      EXPECT_NE(*digest_of_tables(tables), *digest) << path;
      ASSERT_TRUE(write_file(path, text));
    }
  }
}

TEST(LoadKnowledge, RefusesAFileThatIsNoKnowledgeBase) {
  const ScratchFolder folder;
  EXPECT_EQ(load_knowledge(folder.path() / "none.sqlite", Simulator::Ai2thor).error().kind, Error::Kind::Io);
  ASSERT_TRUE(write_file(folder.path() / "text.sqlite", std::string(5000, 'x')));
  const auto loaded = load_knowledge(folder.path() / "text.sqlite", Simulator::Ai2thor);
  ASSERT_FALSE(loaded);
  EXPECT_EQ(format(loaded.error()), (folder.path() / "text.sqlite").string() +
                                        ": schema error: not a compiled knowledge base (file is not a database); "
                                        "expected the output of 'unietp knowledge build'");
  EXPECT_FALSE(digest_of_database(folder.path() / "text.sqlite"));
}

}  // namespace
}  // namespace unietp
