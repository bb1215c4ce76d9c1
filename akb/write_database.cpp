#include <exception>
#include <map>
#include <utility>

#include "akb/database.h"
#include "akb/name_table.h"
#include "core/sqlite_file.h"
#include "core/text.h"
#include "scene/simulator.h"

namespace unietp {
namespace {

using Text = std::string_view;
using Int = std::int64_t;

/// Binds a row's values in the order of the columns and inserts it.
template <class... Values>
void insert(Statement& statement, const Values&... values) {
  int index = 0;
  (statement.bind(++index, values), ...);
  statement.step();
  statement.reset();
}

/// Calls `use` with every text that rows name by number.
template <class Use>
void each_text(const Tables& tables, const Use& use) {
  const auto source = [&](const Source& s) { use(s.source); };
  for (const auto& c : tables.categories) {
    use(c.name), use(std::string(name_of(c.archetype)));
    for (const auto* list : {&c.rooms, &c.colors, &c.materials, &c.kinds}) use(join(*list, "|"));
    use(join(names_of(c.traits), "|"));
    for (const auto* s : {&c.source, &c.size_source, &c.mass_source, &c.synset_source}) source(*s);
  }
  for (const auto& f : tables.affordances) use(f.affordance), source(f.source);
  for (const auto& p : tables.placements) use(std::string(info(p.relation).name)), source(p.source);
  for (const auto& e : tables.effects)
    use(std::string(name_of(e.treatment))), use(e.gives), use(join(names_of(e.needs), "|")), source(e.source);
  for (const auto& a : tables.aliases) use(std::string(name_of(a.kind))), source(a.source);
  for (const auto& a : tables.assets) source(a.source);
}

/// The numbers that stand for a simulator's texts and for its pairs of source and confidence.
class Numbers {
 public:
  explicit Numbers(const Tables& tables) {
    std::vector<std::string> texts;
    std::map<std::string, bool, std::less<>> seen;
    each_text(tables, [&](const std::string& text) {
      if (seen.try_emplace(text, true).second) texts.push_back(text);
    });
    texts_ = NameTable(std::move(texts));
  }
  Int text(Text text) const { return texts_.number(text); }
  Int text(const std::vector<std::string>& list) const { return texts_.number(join(list, "|")); }
  /// New pairs get the next number.
  Int evidence(const Source& source) {
    const auto pair = std::pair{texts_.number(source.source), source.confidence};
    return evidence_.try_emplace(pair, static_cast<Int>(evidence_.size())).first->second;
  }
  void store(SqliteFile& file, Int simulator) const {
    auto text = file.prepare("INSERT INTO text VALUES(?,?,?)");
    for (std::size_t i = 0; i < texts_.size(); ++i)
      insert(text, simulator, static_cast<Int>(i), Text(texts_.names()[i]));
    auto evidence = file.prepare("INSERT INTO evidence VALUES(?,?,?,?)");
    for (const auto& [pair, number] : evidence_) insert(evidence, simulator, number, Int{pair.first}, pair.second);
  }

 private:
  NameTable texts_;
  std::map<std::pair<std::uint32_t, double>, Int> evidence_;
};

void insert_categories(SqliteFile& file, Int simulator, const Tables& tables, Numbers& n) {
  auto statement = file.prepare("INSERT INTO category_row VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
  for (const auto& c : tables.categories) {
    insert(statement, simulator, n.text(c.name), Text(c.display), Text(c.plural), Text(c.synset), Int{c.countable},
           Int{c.movable}, n.text(name_of(c.archetype)), c.size.x(), c.size.y(), c.size.z(), c.mass, n.text(c.rooms),
           n.text(c.colors), n.text(c.materials), n.text(c.kinds), n.text(names_of(c.traits)), n.evidence(c.source),
           n.evidence(c.size_source), n.evidence(c.mass_source), n.evidence(c.synset_source));
  }
}

void insert_facts(SqliteFile& file, Int simulator, const Tables& tables, Numbers& n) {
  auto affordance = file.prepare("INSERT INTO affordance_row VALUES(?,?,?,?)");
  for (const auto& f : tables.affordances)
    insert(affordance, simulator, n.text(f.category), n.text(f.affordance), n.evidence(f.source));
  auto relation = file.prepare("INSERT INTO relation_row VALUES(?,?,?,?,?,?,?)");
  for (const auto& p : tables.placements) {
    insert(relation, simulator, n.text(p.object), n.text(info(p.relation).name), n.text(p.receptacle), p.likelihood,
           Int{p.capacity}, n.evidence(p.source));
  }
  auto effect = file.prepare("INSERT INTO effect_row VALUES(?,?,?,?,?,?,?,?)");
  for (const auto& e : tables.effects) {
    insert(effect, simulator, n.text(e.tool), n.text(name_of(e.treatment)), n.text(e.target), n.text(e.gives),
           Int{e.amount}, n.text(names_of(e.needs)), n.evidence(e.source));
  }
}

void insert_names(SqliteFile& file, Int simulator, const Tables& tables, Numbers& n) {
  auto alias = file.prepare("INSERT INTO alias_row VALUES(?,?,?,?,?)");
  for (const auto& a : tables.aliases)
    insert(alias, simulator, n.text(a.category), n.text(name_of(a.kind)), Text(a.text), n.evidence(a.source));
  auto asset = file.prepare("INSERT INTO asset_row VALUES(?,?,?,?,?,?,?)");
  for (const auto& a : tables.assets) {
    insert(asset, simulator, n.text(a.category), Text(a.name), a.size.x(), a.size.y(), a.size.z(),
           n.evidence(a.source));
  }
}

void insert_sizes(SqliteFile& file, Int simulator, const Tables& tables) {
  auto size = file.prepare("INSERT INTO size VALUES(?,?,?)");
  const auto store = [&](Text table, std::size_t rows) { insert(size, simulator, table, static_cast<Int>(rows)); };
  store("category_row", tables.categories.size());
  store("affordance_row", tables.affordances.size());
  store("relation_row", tables.placements.size());
  store("effect_row", tables.effects.size());
  store("alias_row", tables.aliases.size());
  store("asset_row", tables.assets.size());
}

}  // namespace

std::vector<Error> write_database(const std::filesystem::path& path, const std::string& digest,
                                  const std::vector<Tables>& all) {
  try {
    SqliteFile file(path, SqliteFile::Mode::Create);
    file.run(kDatabaseSchema);
    file.run("BEGIN");
    auto meta = file.prepare("INSERT INTO meta VALUES(?,?)");
    insert(meta, Text("digest"), Text(digest));
    insert(meta, Text("format"), kDatabaseFormat);
    auto simulator = file.prepare("INSERT INTO simulator VALUES(?,?)");
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto id = static_cast<Int>(i);
      insert(simulator, id, name_of(kSimulators[i]));
      insert_sizes(file, id, all[i]);
      Numbers numbers(all[i]);
      insert_categories(file, id, all[i], numbers);
      insert_facts(file, id, all[i], numbers);
      insert_names(file, id, all[i], numbers);
      numbers.store(file, id);
    }
    file.run("COMMIT");
  } catch (const std::exception& failure) {
    return {{Error::Kind::Io, path.string(), {}, std::string("cannot write the knowledge base: ") + failure.what()}};
  }
  return {};
}

}  // namespace unietp
