#include <algorithm>

#include "akb/import_common.h"
#include "akb/row_reader.h"
#include "akb/table_words.h"
#include "core/files.h"

// The last steps of TableBuilder: what is curated by hand lies over what was imported and derived, and only what fits
// stays.
namespace unietp {

template <class Read>
void TableBuilder::with_curated(const std::string& table, const Read& read) {
  const auto path = folder() / (table + ".csv");
  if (!std::filesystem::exists(path)) return;
  const auto text = read_file(path);
  if (!text) {
    errors_.push_back(text.error());
    return;
  }
  RowReader row(path.string(), *text, columns_of(table), errors_);
  for (const auto& cells : row.rows()) {
    row.at(cells);
    read(row);
  }
}

void TableBuilder::overlay_affordances() {
  const auto known = names();
  with_curated("affordance", [&](RowReader& row) {
    AffordanceFact f{row.one_of("category", known, "category"),
                     row.one_of("affordance", affordance_names(), "affordance"), row.source("source", "confidence")};
    if (row.sound()) affordances_[{f.category, f.affordance}] = f;
  });
}

void TableBuilder::overlay_curated() {
  const auto known = names();
  with_curated("relation", [&](RowReader& row) {
    Placement p{row.one_of("object", known, "category"),
                row.value_of("relation", relation_names(), "relation", placement_relation_named),
                row.one_of("receptacle", known, "category"),
                row.number("likelihood", 0, 1000, false),
                row.integer("capacity", 1),
                row.source("source", "confidence")};
    if (row.sound()) placements_[{p.object, info(p.relation).name, p.receptacle}] = p;
  });
  with_curated("effect", [&](RowReader& row) {
    Effect e{row.one_of("tool", known, "category"),
             row.value_of("effect", effect_names(), "effect", treatment_named),
             row.one_of("target", known, "category"),
             row.text("gives"),
             row.integer("amount", 0),
             read_needs(row),
             row.source("source", "confidence")};
    if (row.sound()) effects_[{e.tool, name_of(e.treatment), e.target, e.gives}] = e;
  });
  with_curated("alias", [&](RowReader& row) {
    Alias a{row.one_of("category", known, "category"), row.required("text"), read_alias_kind(row),
            row.source("source", "confidence")};
    if (row.sound()) aliases_[{a.category, name_of(a.kind), a.text}] = a;
  });
}

void TableBuilder::drop_removed() {
  const auto path = folder() / "removed.csv";
  if (!std::filesystem::exists(path)) return;
  const auto text = read_file(path);
  if (!text) {
    errors_.push_back(text.error());
    return;
  }
  RowReader row(path.string(), *text, {"table", "subject", "verb", "object"}, errors_);
  for (const auto& cells : row.rows()) {
    row.at(cells);
    const auto &subject = row.text("subject"), &verb = row.text("verb"), &object = row.text("object");
    std::size_t removed = 0;
    if (row.text("table") == "affordance") {
      removed = affordances_.erase({subject, verb});
    } else if (row.text("table") == "relation") {
      removed = std::erase_if(placements_, [&](const auto& entry) {
        const auto& p = entry.second;
        return p.object == subject && info(p.relation).name == verb && (object == "*" || p.receptacle == object);
      });
    }
    if (row.text("table") == "alias") removed = aliases_.erase({subject, verb, object});
    if (removed == 0)
      row.fail("subject", "nothing to remove; expected a fact of the affordance, relation or alias table");
  }
}

void TableBuilder::add_aliases() {
  for (const auto& path : parts_of(curated_, "aliases", errors_)) add_aliases_of(path);
}

void TableBuilder::add_aliases_of(const std::filesystem::path& path) {
  const auto text = read_file(path);
  if (!text) {
    errors_.push_back(text.error());
    return;
  }
  RowReader row(path.string(), *text, {"display", "kind", "text"}, errors_);
  for (const auto& cells : row.rows()) {
    row.at(cells);
    const auto& display = row.required("display");
    const AliasKind kind = read_alias_kind(row);
    const auto alias = row.required("text");
    if (!lexicon_.contains(display))
      row.fail("display", "no word '" + display + "' in lexicon*.csv; expected one of its rows");
    if (!row.sound()) continue;
    for (const auto& [name, c] : categories_) {
      if (c.display == display)
        aliases_.try_emplace({name, name_of(kind), alias}, Alias{name, alias, kind, {"curated", 0.9}});
    }
  }
}

/// A synonym that is another category's name, or that two categories share, names neither.
void TableBuilder::drop_ambiguous_aliases() {
  std::map<std::string, std::set<std::string>> named;
  for (const auto& [name, c] : categories_) {
    named[c.display].insert(name);
    named[c.plural].insert(name);
  }
  for (const auto& [key, a] : aliases_) {
    if (a.kind == AliasKind::Synonym) named[a.text].insert(a.category);
  }
  std::erase_if(aliases_, [&](const auto& entry) {
    const Alias& a = entry.second;
    if (a.kind != AliasKind::Synonym) return false;
    const Category& own = categories_.at(a.category);
    return named[a.text].size() > 1 || a.text == own.display || a.text == own.plural;
  });
}

Result<Tables> TableBuilder::finish() {
  add_aliases();
  overlay_curated();
  drop_removed();
  if (!errors_.empty()) return errors_.front();
  drop_ambiguous_aliases();
  drop_unfit();
  normalize();
  Tables tables;
  for (auto& [key, row] : categories_) tables.categories.push_back(std::move(row));
  for (auto& [key, row] : affordances_) tables.affordances.push_back(std::move(row));
  for (auto& [key, row] : placements_) tables.placements.push_back(std::move(row));
  for (auto& [key, row] : effects_) tables.effects.push_back(std::move(row));
  for (auto& [key, row] : aliases_) tables.aliases.push_back(std::move(row));
  for (auto& [name, row] : assets_) tables.assets.push_back(std::move(row));
  sort_tables(tables);
  return tables;
}

}  // namespace unietp
