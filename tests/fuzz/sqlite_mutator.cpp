#include "sqlite_mutator.h"

#include <sqlite3.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

#include "core/text.h"

namespace unietp::fuzz {
namespace {

constexpr std::size_t kHeader = 100;    // bytes of a database before its first page's tree
constexpr std::size_t kMost = 1 << 20;  // bytes of a database that is changed
constexpr std::string_view kMagic = "SQLite format 3";

/// `"name"`, as SQL quotes it.
std::string quoted(const std::string& name) { return '"' + replace_all(name, "\"", "\"\"") + '"'; }

/// A database in memory.
class MemoryDatabase {
 public:
  explicit MemoryDatabase(std::string bytes) {
    // A file in WAL mode cannot be opened in memory.
    bytes[18] = bytes[19] = 1;
    sqlite3_open(":memory:", &database_);
    // As a stranger's file it must not cost more than a little.
    sqlite3_limit(database_, SQLITE_LIMIT_LENGTH, static_cast<int>(kMost));
    sqlite3_progress_handler(
        database_, 1'000'000, [](void*) { return 1; }, nullptr);
    auto* copy = static_cast<unsigned char*>(sqlite3_malloc64(bytes.size()));
    std::copy(bytes.begin(), bytes.end(), copy);
    sqlite3_deserialize(database_, "main", copy, static_cast<sqlite3_int64>(bytes.size()),
                        static_cast<sqlite3_int64>(bytes.size()),
                        SQLITE_DESERIALIZE_FREEONCLOSE | SQLITE_DESERIALIZE_RESIZEABLE);
  }
  ~MemoryDatabase() { sqlite3_close_v2(database_); }
  MemoryDatabase(const MemoryDatabase&) = delete;
  MemoryDatabase& operator=(const MemoryDatabase&) = delete;

  bool run(const std::string& sql) {
    return sqlite3_exec(database_, sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK;
  }

  /// The first column of a query's rows, as texts.
  std::vector<std::string> texts(const std::string& sql) {
    std::vector<std::string> texts;
    const auto keep = [](void* into, int, char** values, char**) {
      static_cast<std::vector<std::string>*>(into)->emplace_back(values[0] == nullptr ? "" : values[0]);
      return 0;
    };
    sqlite3_exec(database_, sql.c_str(), keep, &texts, nullptr);
    return texts;
  }

  std::string bytes() const {
    sqlite3_int64 size = 0;
    const std::unique_ptr<unsigned char, void (*)(void*)> all(sqlite3_serialize(database_, "main", &size, 0),
                                                              sqlite3_free);
    return all ? std::string(all.get(), all.get() + size) : std::string();
  }

 private:
  sqlite3* database_ = nullptr;
};

bool is_database(std::string_view bytes) {
  return bytes.size() > kHeader && bytes.size() <= kMost && bytes.starts_with(kMagic);
}

/// SQL literals that a reader may not expect.
const std::vector<std::string>& odd_values() {
  static const std::vector<std::string> values{"NULL",
                                               "0",
                                               "-1",
                                               "2147483648",
                                               "9223372036854775807",
                                               "-9223372036854775808",
                                               "1e308",
                                               "-1e308",
                                               "9e999",
                                               "0.5",
                                               "''",
                                               "'-1'",
                                               "'x'",
                                               "'../../x'",
                                               "char(0)",
                                               "char(10)",
                                               "char(228)",
                                               "x'ff00fe'",
                                               "zeroblob(5000)",
                                               "replace(hex(zeroblob(2000)), '0', 'a|')",
                                               "'{}'",
                                               "'[]'"};
  return values;
}

/// Changes of a database through SQLite. One that SQLite refuses changes nothing.
class RowChange {
 public:
  RowChange(MemoryDatabase& database, std::string_view donor, Rng& rng)
      : database_(database), donor_(donor), rng_(rng) {}

  void make() {
    const auto tables = database_.texts("SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY name");
    if (tables.empty()) return;
    table_ = rng_.pick(tables);
    columns_ = database_.texts("SELECT name FROM pragma_table_info('" + replace_all(table_, "'", "''") + "')");
    if (columns_.empty()) return;
    switch (rng_.below(10)) {
      case 0:
      case 1:
      case 2:
        return set_cell();
      case 3:
        return delete_row();
      case 4:
        return double_row();
      case 5:
        (void)database_.run("UPDATE OR IGNORE " + table() + " SET " + column() + " = " + column());
        return;
      case 6:
        return loosen();
      case 7:
        return change_columns();
      default:
        return change_tables();
    }
  }

 private:
  std::string table() const { return quoted(table_); }
  std::string column() { return quoted(rng_.pick(columns_)); }

  /// Columns that tell a row from the others, in brackets.
  std::string key() {
    const auto keys = database_.texts("SELECT name FROM pragma_table_info('" + replace_all(table_, "'", "''") +
                                      "') WHERE pk > 0 ORDER BY pk");
    std::vector<std::string> names;
    for (const auto& name : keys) names.push_back(quoted(name));
    return names.empty() ? "(rowid)" : "(" + join(names, ", ") + ")";
  }
  /// "WHERE ...": one row.
  std::string one_row() {
    const auto counted = database_.texts("SELECT min(count(*), 1000) FROM " + table());
    const std::uint64_t rows = counted.empty() || counted[0].empty() ? 1 : std::stoull("0" + counted[0]);
    const std::string columns = key();
    return " WHERE " + columns + " IN (SELECT " + columns.substr(1, columns.size() - 2) + " FROM " + table() +
           " LIMIT 1 OFFSET " + std::to_string(rng_.below(rows + 1)) + ")";
  }
  std::string value() {
    if (rng_.chance(0.6)) return rng_.pick(odd_values());
    if (rng_.chance(0.5) && is_database(donor_)) {
      MemoryDatabase other{std::string(donor_)};
      const auto given = other.texts("SELECT quote(" + column() + ") FROM " + table() + " LIMIT 50");
      if (!given.empty()) return rng_.pick(given);
    }
    return "(SELECT " + column() + " FROM " + table() + " LIMIT 1 OFFSET " + std::to_string(rng_.below(5)) + ")";
  }

  void set_cell() {
    const std::string change = "UPDATE OR REPLACE " + table() + " SET " + column() + " = " + value();
    (void)database_.run(change + (rng_.chance(0.1) ? std::string() : one_row()));
  }
  void delete_row() { (void)database_.run("DELETE FROM " + table() + (rng_.chance(0.1) ? std::string() : one_row())); }
  void double_row() {
    loosen();
    (void)database_.run("INSERT OR IGNORE INTO " + table() + " SELECT * FROM " + table() + one_row());
  }

  /// Takes a promise out of the text of the schema, and leaves the rows.
  void loosen() {
    static const std::vector<std::pair<std::string, std::string>> kLooser{
        {" STRICT", ""},      {" NOT NULL", ""}, {"INTEGER", "TEXT"},         {"REAL", "INTEGER"},
        {" PRIMARY KEY", ""}, {"TEXT", "BLOB"},  {"WITHOUT ROWID", "STRICT"}, {"TEXT", "TEXT COLLATE NOCASE"}};
    const auto& [from, to] = rng_.pick(kLooser);
    (void)database_.run("PRAGMA writable_schema=ON; UPDATE sqlite_schema SET sql = replace(sql, '" + from + "', '" +
                        to + "') WHERE name = '" + replace_all(table_, "'", "''") + "'; PRAGMA writable_schema=RESET");
  }

  void change_columns() {
    const std::vector<std::string> changes{
        "ALTER TABLE " + table() + " DROP COLUMN " + column(),
        "ALTER TABLE " + table() + " RENAME COLUMN " + column() + " TO other",
        "ALTER TABLE " + table() + " ADD COLUMN more DEFAULT 1",
        "ALTER TABLE " + table() + " ADD COLUMN made AS (hex(zeroblob(400)))",
        "CREATE INDEX own ON " + table() + "(" + column() + ")",
    };
    (void)database_.run(rng_.pick(changes));
  }

  void change_tables() {
    const std::string aside = "ALTER TABLE " + table() + " RENAME TO aside; ";
    const std::vector<std::string> changes{
        "DROP TABLE " + table(),
        aside,
        aside + "CREATE VIEW " + table() + " AS SELECT * FROM aside",
        aside + "CREATE VIEW " + table() + " AS SELECT a.* FROM aside a, aside b, aside c, aside d",
        aside + "CREATE VIEW " + table() +
            " AS WITH RECURSIVE n(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM n) SELECT aside.* FROM aside, n",
        aside + "CREATE TABLE " + table() + " AS SELECT * FROM aside ORDER BY 1 DESC LIMIT 2",
        "CREATE TRIGGER own AFTER UPDATE ON " + table() + " BEGIN DELETE FROM " + table() + "; END",
        "CREATE TRIGGER own BEFORE INSERT ON " + table() + " BEGIN SELECT RAISE(IGNORE); END",
        "PRAGMA user_version = 7",
        "PRAGMA page_size = 1024; VACUUM",
    };
    (void)database_.run(rng_.pick(changes));
  }

  MemoryDatabase& database_;
  std::string_view donor_;
  Rng& rng_;
  std::string table_;
  std::vector<std::string> columns_;
};

/// Overwrites bytes of the pages: one, a number of two or four bytes, a page by another; or cuts pages off.
void change_page(std::string& bytes, Rng& rng) {
  const auto high = static_cast<unsigned char>(bytes[16]), low = static_cast<unsigned char>(bytes[17]);
  const std::size_t page = std::clamp<std::size_t>(static_cast<std::size_t>(high << 8 | low), 512, 65536);
  const std::size_t pages = std::max<std::size_t>(bytes.size() / page, 1);
  const std::size_t start = rng.below(pages) * page;
  // The head of a page and its list of cells decide how it is read, so they change more often than what is behind.
  const std::size_t reach = rng.chance(0.5) ? 40 : page;
  const std::size_t at = std::max(start, start == 0 ? kHeader : start) + rng.below(reach);
  const auto put = [&](std::uint64_t value, std::size_t width) {
    for (std::size_t i = 0; i < width && at + i < bytes.size(); ++i)
      bytes[at + i] = static_cast<char>(value >> (8 * (width - 1 - i)));
  };
  switch (rng.below(5)) {
    case 0:
      return put(rng.below(256), 1);
    case 1:
      return put(rng.below(page + 2), 2);
    case 2:
      return put(rng.below(pages + 2), 4);
    case 3: {
      const std::size_t from = rng.below(pages) * page;
      const std::string copy = bytes.substr(from, page);
      if (start != 0) bytes.replace(start, std::min(copy.size(), bytes.size() - start), copy);
      return;
    }
    default:
      if (start != 0) bytes.resize(start);
  }
}

}  // namespace

std::optional<std::string> mutate_sqlite(std::string_view bytes, std::string_view donor, Rng rng) {
  if (!is_database(bytes)) return std::nullopt;
  std::string changed(bytes);
  for (std::uint64_t changes = 1 + rng.below(3); changes > 0; --changes) {
    if (rng.chance(0.3)) {
      change_page(changed, rng);
      continue;
    }
    MemoryDatabase database(changed);
    RowChange(database, donor, rng).make();
    if (std::string again = database.bytes(); is_database(again)) changed = std::move(again);
  }
  return changed;
}

}  // namespace unietp::fuzz
