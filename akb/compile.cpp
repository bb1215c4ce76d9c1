#include <exception>
#include <system_error>

#include "akb/knowledge.h"
#include "akb/tables.h"
#include "core/digest.h"
#include "core/files.h"
#include "core/sqlite_file.h"
#include "core/text.h"

namespace unietp {
namespace {

constexpr const char* kSchema = R"(
PRAGMA journal_mode=OFF; PRAGMA synchronous=OFF; PRAGMA page_size=4096;
CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL) STRICT;
CREATE TABLE category(simulator TEXT NOT NULL, name TEXT NOT NULL, display TEXT NOT NULL, plural TEXT NOT NULL,
  synset TEXT NOT NULL, countable INTEGER NOT NULL, movable INTEGER NOT NULL, archetype TEXT NOT NULL,
  width REAL NOT NULL, depth REAL NOT NULL, height REAL NOT NULL, mass REAL NOT NULL, rooms TEXT NOT NULL,
  colours TEXT NOT NULL, materials TEXT NOT NULL, source TEXT NOT NULL, confidence REAL NOT NULL,
  size_source TEXT NOT NULL, size_confidence REAL NOT NULL, mass_source TEXT NOT NULL, mass_confidence REAL NOT NULL,
  PRIMARY KEY(simulator, name)) STRICT, WITHOUT ROWID;
CREATE TABLE affordance(simulator TEXT NOT NULL, category TEXT NOT NULL, affordance TEXT NOT NULL,
  source TEXT NOT NULL, confidence REAL NOT NULL, PRIMARY KEY(simulator, category, affordance)) STRICT, WITHOUT ROWID;
CREATE TABLE relation(simulator TEXT NOT NULL, object TEXT NOT NULL, relation TEXT NOT NULL, receptacle TEXT NOT NULL,
  likelihood REAL NOT NULL, capacity INTEGER NOT NULL, source TEXT NOT NULL, confidence REAL NOT NULL,
  PRIMARY KEY(simulator, object, relation, receptacle)) STRICT, WITHOUT ROWID;
CREATE TABLE effect(simulator TEXT NOT NULL, tool TEXT NOT NULL, effect TEXT NOT NULL, target TEXT NOT NULL,
  gives TEXT NOT NULL, amount INTEGER NOT NULL, needs TEXT NOT NULL, source TEXT NOT NULL, confidence REAL NOT NULL,
  PRIMARY KEY(simulator, tool, effect, target, gives)) STRICT, WITHOUT ROWID;
CREATE TABLE alias(simulator TEXT NOT NULL, category TEXT NOT NULL, kind TEXT NOT NULL, text TEXT NOT NULL,
  source TEXT NOT NULL, confidence REAL NOT NULL, PRIMARY KEY(simulator, category, kind, text)) STRICT, WITHOUT ROWID;
CREATE TABLE asset(simulator TEXT NOT NULL, category TEXT NOT NULL, asset TEXT NOT NULL, width REAL NOT NULL,
  depth REAL NOT NULL, height REAL NOT NULL, source TEXT NOT NULL, confidence REAL NOT NULL,
  PRIMARY KEY(simulator, category, asset)) STRICT, WITHOUT ROWID;
)";

/// Binds a row's values in the order of the columns and inserts it.
template <class... Values>
void insert(Statement& statement, const Values&... values) {
  int index = 0;
  (statement.bind(++index, values), ...);
  statement.step();
  statement.reset();
}

using Text = std::string_view;
using Int = std::int64_t;

void insert_tables(SqliteFile& file, Text simulator, const Tables& tables) {
  auto category = file.prepare("INSERT INTO category VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
  for (const auto& c : tables.categories) {
    insert(category, simulator, Text(c.name), Text(c.display), Text(c.plural), Text(c.synset), Int{c.countable},
           Int{c.movable}, name_of(c.archetype), c.size.x(), c.size.y(), c.size.z(), c.mass, Text(join(c.rooms, "|")),
           Text(join(c.colours, "|")), Text(join(c.materials, "|")), Text(c.source.source), c.source.confidence,
           Text(c.size_source.source), c.size_source.confidence, Text(c.mass_source.source), c.mass_source.confidence);
  }
  auto affordance = file.prepare("INSERT INTO affordance VALUES(?,?,?,?,?)");
  for (const auto& f : tables.affordances) {
    insert(affordance, simulator, Text(f.category), Text(f.affordance), Text(f.source.source), f.source.confidence);
  }
  auto relation = file.prepare("INSERT INTO relation VALUES(?,?,?,?,?,?,?,?)");
  for (const auto& p : tables.placements) {
    insert(relation, simulator, Text(p.object), Text(p.relation), Text(p.receptacle), p.likelihood, Int{p.capacity},
           Text(p.source.source), p.source.confidence);
  }
  auto effect = file.prepare("INSERT INTO effect VALUES(?,?,?,?,?,?,?,?,?)");
  for (const auto& e : tables.effects) {
    insert(effect, simulator, Text(e.tool), Text(e.effect), Text(e.target), Text(e.gives), Int{e.amount},
           Text(join(e.needs, "|")), Text(e.source.source), e.source.confidence);
  }
  auto alias = file.prepare("INSERT INTO alias VALUES(?,?,?,?,?,?)");
  for (const auto& a : tables.aliases) {
    insert(alias, simulator, Text(a.category), Text(a.kind), Text(a.text), Text(a.source.source), a.source.confidence);
  }
  auto asset = file.prepare("INSERT INTO asset VALUES(?,?,?,?,?,?,?,?)");
  for (const auto& a : tables.assets) {
    insert(asset, simulator, Text(a.category), Text(a.name), a.size.x(), a.size.y(), a.size.z(), Text(a.source.source),
           a.source.confidence);
  }
}

Error io_error(const std::filesystem::path& path, std::string message) {
  return {Error::Kind::Io, path.string(), {}, std::move(message)};
}

/// Fills a new file; a SQLite failure comes back as an error.
std::vector<Error> write_database(const std::filesystem::path& path, const std::string& digest,
                                  const std::vector<Tables>& all) {
  try {
    SqliteFile file(path, SqliteFile::Mode::Create);
    file.run(kSchema);
    file.run("BEGIN");
    auto meta = file.prepare("INSERT INTO meta VALUES(?,?)");
    insert(meta, Text("digest"), Text(digest));
    insert(meta, Text("format"), Text("unietp-knowledge/2"));
    for (std::size_t i = 0; i < all.size(); ++i) insert_tables(file, name_of(kSimulators[i]), all[i]);
    file.run("COMMIT");
  } catch (const std::exception& failure) {
    return {io_error(path, std::string("cannot write the knowledge base: ") + failure.what())};
  }
  return {};
}

}  // namespace

std::vector<Error> compile_knowledge(const std::filesystem::path& tables, const std::filesystem::path& database) {
  std::vector<Error> errors;
  std::vector<Tables> all;
  for (const auto simulator : kSimulators) {
    all.push_back(read_tables(tables / std::string(name_of(simulator)), errors));
    sort_tables(all.back());
  }
  if (!errors.empty()) return errors;
  const auto digest = digest_of_tables(tables);
  if (!digest) return {digest.error()};

  std::error_code code;
  auto aside = database;
  aside += ".tmp";
  if (database.has_parent_path()) std::filesystem::create_directories(database.parent_path(), code);
  std::filesystem::remove(aside, code);
  errors = write_database(aside, *digest, all);
  if (errors.empty()) {
    std::filesystem::rename(aside, database, code);
    if (code) errors.push_back(io_error(database, "cannot rename the new knowledge base: " + code.message()));
  }
  if (!errors.empty()) std::filesystem::remove(aside, code);
  return errors;
}

Result<std::string> digest_of_tables(const std::filesystem::path& tables) {
  std::string all;
  for (const auto simulator : kSimulators) {
    for (const auto& table : table_names()) {
      const auto name = std::string(name_of(simulator)) + "/" + table + ".csv";
      const auto text = read_file(tables / name);
      if (!text) return text.error();
      all += name + "\n" + std::to_string(text->size()) + "\n" + *text;
    }
  }
  return sha256(all);
}

}  // namespace unietp
