#include "akb/tables.h"

#include <initializer_list>
#include <unordered_set>

#include "akb/row_reader.h"
#include "akb/table_words.h"
#include "core/files.h"
#include "core/limits.h"
#include "core/text.h"

namespace unietp {
namespace {

std::vector<std::string> archetype_names() {
  std::vector<std::string> names;
  for (const auto archetype : all_archetypes()) names.emplace_back(name_of(archetype));
  return names;
}

/// Keys of the rows seen so far; a row whose key was seen is a fault of `column`.
class UniqueKeys {
 public:
  void check(RowReader& row, std::string_view column, std::initializer_list<std::string_view> key) {
    if (!row.sound()) return;
    std::string joined;
    for (const auto part : key) {
      if (!joined.empty()) joined += '\x1f';
      joined += part;
    }
    if (!seen_.insert(joined).second)
      row.fail(column, "row for '" + replace_all(joined, "\x1f", " ") + "' is duplicated; expected one row per key");
  }

 private:
  std::unordered_set<std::string> seen_;
};

std::vector<Category> read_categories(RowReader& row) {
  const auto archetypes = archetype_names();
  std::vector<Category> categories;
  UniqueKeys keys;
  for (const auto& cells : row.rows()) {
    row.at(cells);
    Category c;
    c.name = row.required("name");
    c.display = row.required("display");
    c.plural = row.required("plural");
    c.synset = row.text("synset");
    c.countable = row.flag("countable");
    c.movable = row.flag("movable");
    c.archetype = archetype_named(row.one_of("archetype", archetypes, "archetype")).value_or(Archetype::Box);
    c.size = {row.number("width", 0, limits::kCategory_m, false), row.number("depth", 0, limits::kCategory_m, false),
              row.number("height", 0, limits::kCategory_m, false)};
    c.mass = row.number("mass", 0, limits::kCategory_kg, false);
    c.rooms = row.all_of("rooms", room_types(), "room type");
    c.colors = row.list("colours");
    c.materials = row.list("materials");
    c.source = c.synset_source = row.source("source", "confidence");
    c.size_source = row.source("size_source", "size_confidence");
    c.mass_source = row.source("mass_source", "mass_confidence");
    keys.check(row, "name", {c.name});
    if (row.sound()) categories.push_back(std::move(c));
  }
  return categories;
}

std::vector<AffordanceFact> read_affordances(RowReader& row, const NameTable& names) {
  std::vector<AffordanceFact> facts;
  UniqueKeys keys;
  for (const auto& cells : row.rows()) {
    row.at(cells);
    AffordanceFact fact;
    fact.category = row.one_of("category", names, "category");
    fact.affordance = row.one_of("affordance", affordance_names(), "affordance");
    fact.source = row.source("source", "confidence");
    keys.check(row, "category", {fact.category, fact.affordance});
    if (row.sound()) facts.push_back(std::move(fact));
  }
  return facts;
}

std::vector<Placement> read_placements(RowReader& row, const NameTable& names) {
  std::vector<Placement> placements;
  UniqueKeys keys;
  for (const auto& cells : row.rows()) {
    row.at(cells);
    Placement p;
    p.object = row.one_of("object", names, "category");
    p.relation = row.value_of("relation", relation_names(), "relation", placement_relation_named);
    p.receptacle = row.one_of("receptacle", names, "category");
    p.likelihood = row.number("likelihood", 0, 1, false);
    p.capacity = row.integer("capacity", 1);
    p.source = row.source("source", "confidence");
    keys.check(row, "object", {p.object, std::string(info(p.relation).name), p.receptacle});
    if (row.sound()) placements.push_back(std::move(p));
  }
  return placements;
}

std::vector<Effect> read_effects(RowReader& row, const NameTable& names) {
  std::vector<Effect> effects;
  UniqueKeys keys;
  for (const auto& cells : row.rows()) {
    row.at(cells);
    Effect e;
    e.tool = row.one_of("tool", names, "category");
    e.treatment = row.value_of("effect", effect_names(), "effect", treatment_named);
    e.target = row.one_of("target", names, "category");
    e.gives = e.treatment == Treatment::Slices ? row.one_of("gives", names, "category") : row.text("gives");
    e.amount = row.integer("amount", e.treatment == Treatment::Slices ? 1 : 0);
    e.needs = read_needs(row);
    e.source = row.source("source", "confidence");
    keys.check(row, "tool", {e.tool, std::string(name_of(e.treatment)), e.target, e.gives});
    if (row.sound()) effects.push_back(std::move(e));
  }
  return effects;
}

std::vector<Alias> read_aliases(RowReader& row, const NameTable& names) {
  std::vector<Alias> aliases;
  UniqueKeys keys;
  for (const auto& cells : row.rows()) {
    row.at(cells);
    Alias a;
    a.category = row.one_of("category", names, "category");
    a.kind = read_alias_kind(row);
    a.text = row.required("text");
    a.source = row.source("source", "confidence");
    keys.check(row, "category", {a.category, std::string(name_of(a.kind)), a.text});
    if (row.sound()) aliases.push_back(std::move(a));
  }
  return aliases;
}

std::vector<Asset> read_assets(RowReader& row, const NameTable& names) {
  std::vector<Asset> assets;
  UniqueKeys keys;
  for (const auto& cells : row.rows()) {
    row.at(cells);
    Asset a;
    a.name = row.required("asset");
    a.category = row.one_of("category", names, "category");
    a.size = {row.number("width", 0, limits::kCategory_m, false), row.number("depth", 0, limits::kCategory_m, false),
              row.number("height", 0, limits::kCategory_m, false)};
    a.source = row.source("source", "confidence");
    keys.check(row, "asset", {a.name});
    if (row.sound()) assets.push_back(std::move(a));
  }
  return assets;
}

}  // namespace

std::vector<EffectNeed> read_needs(RowReader& row) {
  std::vector<EffectNeed> needs;
  for (const auto& name : row.all_of("needs", need_names(), "need")) {
    if (const auto need = effect_need_named(name)) needs.push_back(*need);
  }
  return needs;
}

AliasKind read_alias_kind(RowReader& row) {
  return row.value_of("kind", alias_kinds(), "kind of alias", alias_kind_named);
}

const std::vector<std::string>& table_names() {
  static const std::vector<std::string> names{"category", "affordance", "relation", "effect", "alias", "asset"};
  return names;
}

const std::vector<std::string>& columns_of(std::string_view table) {
  static const std::vector<std::string> category{"name",        "display",         "plural",      "synset",
                                                 "countable",   "movable",         "archetype",   "width",
                                                 "depth",       "height",          "mass",        "rooms",
                                                 "colours",     "materials",       "source",      "confidence",
                                                 "size_source", "size_confidence", "mass_source", "mass_confidence"};
  static const std::vector<std::string> affordance{"category", "affordance", "source", "confidence"};
  static const std::vector<std::string> relation{"object",   "relation", "receptacle", "likelihood",
                                                 "capacity", "source",   "confidence"};
  static const std::vector<std::string> effect{"tool",   "effect", "target", "gives",
                                               "amount", "needs",  "source", "confidence"};
  static const std::vector<std::string> alias{"category", "kind", "text", "source", "confidence"};
  static const std::vector<std::string> asset{"asset", "category", "width", "depth", "height", "source", "confidence"};
  if (table == "category") return category;
  if (table == "affordance") return affordance;
  if (table == "relation") return relation;
  if (table == "effect") return effect;
  return table == "alias" ? alias : asset;
}

Tables read_tables(const std::filesystem::path& folder, std::vector<Error>& errors) {
  Tables tables;
  NameTable names;
  const auto with_rows = [&](const std::string& table, const auto& read) {
    const auto path = folder / (table + ".csv");
    const auto text = read_file(path);
    if (!text) {
      errors.push_back(text.error());
      return;
    }
    RowReader row(path.string(), *text, columns_of(table), errors);
    read(row);
  };
  // A category whose own row is faulty is still a name that other tables may use: one fault, one message.
  with_rows("category", [&](RowReader& row) {
    tables.categories = read_categories(row);
    std::vector<std::string> all;
    for (const auto& cells : row.rows()) {
      row.at(cells);
      all.push_back(row.text("name"));
    }
    names = NameTable(std::move(all));
  });
  with_rows("affordance", [&](RowReader& row) { tables.affordances = read_affordances(row, names); });
  with_rows("relation", [&](RowReader& row) { tables.placements = read_placements(row, names); });
  with_rows("effect", [&](RowReader& row) { tables.effects = read_effects(row, names); });
  with_rows("alias", [&](RowReader& row) { tables.aliases = read_aliases(row, names); });
  with_rows("asset", [&](RowReader& row) { tables.assets = read_assets(row, names); });
  return tables;
}

}  // namespace unietp
