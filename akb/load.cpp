#include <exception>
#include <filesystem>

#include "akb/knowledge.h"
#include "core/sqlite_file.h"
#include "core/text.h"

namespace unietp {
namespace {

std::vector<std::string> list(std::string_view text) {
  return text.empty() ? std::vector<std::string>{} : split(text, '|');
}

/// Reads the columns of a row one after the other, in the order of the SELECT.
class Columns {
 public:
  explicit Columns(Statement& statement) : statement_(statement) {}
  std::string text() { return std::string(statement_.text(at_++)); }
  std::vector<std::string> items() { return list(statement_.text(at_++)); }
  double number() { return statement_.number(at_++); }
  int integer() { return static_cast<int>(statement_.integer(at_++)); }
  Source source() {
    Source source;
    source.source = text();
    source.confidence = number();
    return source;
  }

 private:
  Statement& statement_;
  int at_ = 1;  // column 0 is the simulator
};

/// Every row of one simulator, in key order.
template <class Row, class Read>
std::vector<Row> rows_of(SqliteFile& file, const std::string& table, Simulator simulator, const Read& read) {
  auto statement = file.prepare("SELECT * FROM " + table + " WHERE simulator = ?");
  statement.bind(1, name_of(simulator));
  std::vector<Row> rows;
  while (statement.step()) {
    Columns columns(statement);
    read(columns, rows.emplace_back());
  }
  return rows;
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
  auto categories = rows_of<Category>(file, "category", simulator, [](Columns& from, Category& c) {
    c.name = from.text();
    c.display = from.text();
    c.plural = from.text();
    c.synset = from.text();
    c.countable = from.integer() != 0;
    c.movable = from.integer() != 0;
    const auto archetype = from.text();
    if (!archetype_named(archetype)) throw std::runtime_error("unknown archetype '" + archetype + "'");
    c.archetype = *archetype_named(archetype);
    for (int axis = 0; axis < 3; ++axis) c.size[axis] = from.number();
    c.mass = from.number();
    c.rooms = from.items();
    c.colours = from.items();
    c.materials = from.items();
    c.source = from.source();
    c.size_source = from.source();
    c.mass_source = from.source();
  });
  auto affordances = rows_of<AffordanceFact>(file, "affordance", simulator, [](Columns& from, AffordanceFact& f) {
    f.category = from.text();
    f.affordance = from.text();
    f.source = from.source();
  });
  auto placements = rows_of<Placement>(file, "relation", simulator, [](Columns& from, Placement& p) {
    p.object = from.text();
    p.relation = from.text();
    p.receptacle = from.text();
    p.likelihood = from.number();
    p.capacity = from.integer();
    p.source = from.source();
  });
  auto effects = rows_of<Effect>(file, "effect", simulator, [](Columns& from, Effect& e) {
    e.tool = from.text();
    e.effect = from.text();
    e.target = from.text();
    e.gives = from.text();
    e.amount = from.integer();
    e.needs = from.items();
    e.source = from.source();
  });
  auto aliases = rows_of<Alias>(file, "alias", simulator, [](Columns& from, Alias& a) {
    a.category = from.text();
    a.kind = from.text();
    a.text = from.text();
    a.source = from.source();
  });
  auto assets = rows_of<Asset>(file, "asset", simulator, [](Columns& from, Asset& a) {
    a.category = from.text();
    a.name = from.text();
    for (int axis = 0; axis < 3; ++axis) a.size[axis] = from.number();
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
    if (const auto format = meta(file, "format"); format != "unietp-knowledge/2") {
      return schema_error(database, "format '" + format + "'");
    }
    return read_all(file, simulator);
  } catch (const std::exception& failure) {
    return schema_error(database, failure.what());
  }
}

}  // namespace unietp
