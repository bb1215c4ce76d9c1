#include <algorithm>
#include <exception>
#include <filesystem>
#include <stdexcept>

#include "akb/database.h"
#include "akb/knowledge.h"
#include "core/limits.h"
#include "core/sqlite_file.h"
#include "core/text.h"

namespace unietp {
namespace {

std::vector<std::string> list(std::string_view text) {
  return text.empty() ? std::vector<std::string>{} : split(text, '|');
}

/// What rows of one simulator name by number.
struct Numbered {
  std::vector<std::string> texts;
  std::vector<Source> evidence;

  template <class Thing>
  static const Thing& at(const std::vector<Thing>& things, std::int64_t number) {
    if (number < 0 || static_cast<std::size_t>(number) >= things.size())
      throw std::runtime_error("number " + std::to_string(number) + " has no name");
    return things[static_cast<std::size_t>(number)];
  }
};

/// The value that a word stands for. Throws for a word that is not known.
template <class Value>
Value value_of(const std::string& word, std::optional<Value> (*named)(std::string_view)) {
  const auto value = named(word);
  if (!value) throw std::runtime_error("unknown word '" + word + "'");
  return *value;
}

/// Reads the columns of a row one after the other, in the order of the table.
class Columns {
 public:
  Columns(Statement& statement, const Numbered& numbered) : statement_(statement), numbered_(numbered) {}
  std::string text() { return std::string(statement_.text(at_++)); }
  const std::string& name() { return Numbered::at(numbered_.texts, statement_.integer(at_++)); }
  std::vector<std::string> items() { return list(name()); }
  const Source& source() { return Numbered::at(numbered_.evidence, statement_.integer(at_++)); }
  double number() { return statement_.number(at_++); }
  int integer() { return static_cast<int>(statement_.integer(at_++)); }
  Vec3 size() {
    const double width = number(), depth = number();
    return {width, depth, number()};
  }

 private:
  Statement& statement_;
  const Numbered& numbered_;
  int at_ = 1;  // column 0 is the simulator
};

/// How many rows the writer says that a table has, so that memory is asked for once.
std::size_t rows_in(SqliteFile& file, const std::string& table, Simulator simulator) {
  auto statement = file.prepare("SELECT rows FROM size WHERE simulator = ? AND name = ?");
  statement.bind(1, static_cast<std::int64_t>(simulator));
  statement.bind(2, table);
  const std::int64_t rows = statement.step() ? statement.integer(0) : 0;
  return static_cast<std::size_t>(std::clamp<std::int64_t>(rows, 0, limits::kReservedRows));
}

/// Every row of one simulator, in key order.
template <class Row, class Read>
std::vector<Row> rows_of(SqliteFile& file, const std::string& table, Simulator simulator, const Numbered& numbered,
                         const Read& read) {
  auto statement = file.prepare("SELECT * FROM " + table + " WHERE simulator = ?");
  statement.bind(1, static_cast<std::int64_t>(simulator));
  std::vector<Row> rows;
  rows.reserve(rows_in(file, table, simulator));
  while (statement.step()) {
    Columns columns(statement, numbered);
    read(columns, rows.emplace_back());
  }
  return rows;
}

Numbered read_numbered(SqliteFile& file, Simulator simulator) {
  Numbered numbered;
  numbered.texts = rows_of<std::string>(file, "text", simulator, numbered, [](Columns& from, std::string& text) {
    from.integer();  // its number is its place
    text = from.text();
  });
  numbered.evidence = rows_of<Source>(file, "evidence", simulator, numbered, [](Columns& from, Source& source) {
    from.integer();
    source.source = from.name();
    source.confidence = from.number();
  });
  return numbered;
}

Error schema_error(const std::filesystem::path& database, const std::string& reason) {
  return {Error::Kind::Schema,
          database.string(),
          {},
          "not a compiled knowledge base (" + reason + "); expected the output of 'unietp knowledge build'"};
}

Error missing(const std::filesystem::path& database) {
  return {Error::Kind::Io, database.string(), {}, "no such file; expected a compiled knowledge base"};
}

Knowledge read_all(SqliteFile& file, Simulator simulator) {
  const Numbered numbered = read_numbered(file, simulator);
  auto categories = rows_of<Category>(file, "category_row", simulator, numbered, [](Columns& from, Category& c) {
    c.name = from.name();
    c.display = from.text();
    c.plural = from.text();
    c.synset = from.text();
    c.countable = from.integer() != 0;
    c.movable = from.integer() != 0;
    c.archetype = value_of(from.name(), archetype_named);
    c.size = from.size();
    c.mass = from.number();
    c.rooms = from.items();
    c.colors = from.items();
    c.materials = from.items();
    c.kinds = from.items();
    for (const auto& trait : from.items()) c.traits.push_back(value_of(trait, kind_trait_named));
    c.source = from.source();
    c.size_source = from.source();
    c.mass_source = from.source();
    c.synset_source = from.source();
  });
  auto affordances =
      rows_of<AffordanceFact>(file, "affordance_row", simulator, numbered, [](Columns& from, AffordanceFact& f) {
        f.category = from.name();
        f.affordance = from.name();
        f.source = from.source();
      });
  auto placements = rows_of<Placement>(file, "relation_row", simulator, numbered, [](Columns& from, Placement& p) {
    p.object = from.name();
    p.relation = value_of(from.name(), placement_relation_named);
    p.receptacle = from.name();
    p.likelihood = from.number();
    p.capacity = from.integer();
    p.source = from.source();
  });
  auto effects = rows_of<Effect>(file, "effect_row", simulator, numbered, [](Columns& from, Effect& e) {
    e.tool = from.name();
    e.treatment = value_of(from.name(), treatment_named);
    e.target = from.name();
    e.gives = from.name();
    e.amount = from.integer();
    for (const auto& need : from.items()) e.needs.push_back(value_of(need, effect_need_named));
    e.source = from.source();
  });
  auto aliases = rows_of<Alias>(file, "alias_row", simulator, numbered, [](Columns& from, Alias& a) {
    a.category = from.name();
    a.kind = value_of(from.name(), alias_kind_named);
    a.text = from.text();
    a.source = from.source();
  });
  auto assets = rows_of<Asset>(file, "asset_row", simulator, numbered, [](Columns& from, Asset& a) {
    a.category = from.name();
    a.name = from.text();
    a.size = from.size();
    a.source = from.source();
  });
  return {simulator,          std::move(categories), std::move(affordances), std::move(placements),
          std::move(effects), std::move(aliases),    std::move(assets)};
}

/// Value of a key of table meta. Throws what SQLite reports.
std::string meta(SqliteFile& file, std::string_view key) {
  auto statement = file.prepare("SELECT value FROM meta WHERE key = ?");
  statement.bind(1, key);
  if (!statement.step()) throw std::runtime_error("no '" + std::string(key) + "' in table meta");
  return std::string(statement.text(0));
}

}  // namespace

Result<std::string> digest_of_database(const std::filesystem::path& database) {
  if (!std::filesystem::exists(database)) return missing(database);
  try {
    SqliteFile file(database, SqliteFile::Mode::Read);
    return meta(file, "digest");
  } catch (const std::exception& failure) {
    return schema_error(database, failure.what());
  }
}

Result<Knowledge> load_knowledge(const std::filesystem::path& database, Simulator simulator) {
  if (!std::filesystem::exists(database)) return missing(database);
  try {
    SqliteFile file(database, SqliteFile::Mode::Read);
    if (const auto format = meta(file, "format"); format != kDatabaseFormat) {
      return schema_error(database, "format '" + format + "'");
    }
    return read_all(file, simulator);
  } catch (const std::exception& failure) {
    return schema_error(database, failure.what());
  }
}

}  // namespace unietp
