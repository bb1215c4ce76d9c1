#include <algorithm>
#include <cmath>

#include "akb/completed.h"
#include "akb/fit.h"
#include "akb/row_reader.h"
#include "core/files.h"
#include "scene/simulator.h"

namespace unietp {
namespace {

using AffordancesOf = std::map<std::string, std::set<std::string, std::less<>>, std::less<>>;

std::map<std::string, Category*, std::less<>> by_name(Tables& tables) {
  std::map<std::string, Category*, std::less<>> found;
  for (auto& c : tables.categories) found.emplace(c.name, &c);
  return found;
}

/// Everything that names a category in a text, with the categories that it names.
std::map<std::string, std::set<std::string>> names_in(const Tables& tables) {
  std::map<std::string, std::set<std::string>> named;
  for (const auto& c : tables.categories) {
    named[c.display].insert(c.name);
    named[c.plural].insert(c.name);
  }
  for (const auto& a : tables.aliases) {
    if (a.kind == AliasKind::Synonym) named[a.text].insert(a.category);
  }
  return named;
}

void lay_aliases(const CompletedFacts& facts, const StatedFacts& stated, Tables& tables) {
  std::vector<Alias> wanted;
  for (const auto& a : facts.aliases) {
    if (!is_stated(stated, kind_of(a), a.category)) wanted.push_back(a);
  }
  auto named = names_in(tables);
  for (const auto& a : wanted) {
    if (a.kind == AliasKind::Synonym) named[a.text].insert(a.category);
  }
  for (const auto& c : tables.categories) {  // its own name is no synonym
    named[c.display].insert("");
    named[c.plural].insert("");
  }
  for (auto& a : wanted) {
    if (a.kind != AliasKind::Synonym || named[a.text].size() == 1) tables.aliases.push_back(std::move(a));
  }
}

void lay_placements(const CompletedFacts& facts, const StatedFacts& stated, Tables& tables) {
  const auto categories = by_name(tables);
  AffordancesOf affordances;
  for (const auto& f : tables.affordances) affordances[f.category].insert(f.affordance);
  std::vector<Placement> kept;
  std::map<std::string, double> sum;
  for (auto p : facts.placements) {
    const auto object = categories.find(p.object), receptacle = categories.find(p.receptacle);
    if (object == categories.end() || receptacle == categories.end()) continue;
    if (is_stated(stated, FactKind::Placements, p.object)) continue;
    if (!can_be_kept(*object->second, p.relation, *receptacle->second, affordances[p.receptacle])) continue;
    p.capacity = std::min(p.capacity, capacity_of(*object->second, p.relation, *receptacle->second));
    sum[p.object] += p.likelihood;
    kept.push_back(std::move(p));
  }
  for (auto& p : kept) {
    p.likelihood = std::max(1e-4, std::round(p.likelihood / sum[p.object] * 1e4) / 1e4);
    tables.placements.push_back(std::move(p));
  }
}

/// Facts that somebody took back by hand stay away, whoever tells them.
void drop_removed(const std::filesystem::path& path, CompletedFacts& facts, std::vector<Error>& errors) {
  if (!std::filesystem::exists(path)) return;
  const auto text = read_file(path);
  if (!text) {
    errors.push_back(text.error());
    return;
  }
  RowReader row(path.string(), *text, {"table", "subject", "verb", "object"}, errors);
  for (const auto& cells : row.rows()) {
    row.at(cells);
    const auto &subject = row.text("subject"), &verb = row.text("verb"), &object = row.text("object");
    if (row.text("table") == "affordance") {
      std::erase_if(facts.affordances,
                    [&](const AffordanceFact& f) { return f.category == subject && f.affordance == verb; });
    } else {
      std::erase_if(facts.placements, [&](const Placement& p) {
        return p.object == subject && info(p.relation).name == verb && (object == "*" || p.receptacle == object);
      });
    }
  }
}

}  // namespace

void lay_completed(const std::filesystem::path& tables_folder, Simulator simulator, const StatedFacts& stated,
                   Tables& tables, std::vector<Error>& errors) {
  if (completed_files(tables_folder, simulator).empty()) return;
  auto facts = read_completed(completed_folder(tables_folder, simulator), tables, errors);
  drop_removed(removed_file(tables_folder, simulator), facts, errors);
  lay_under(facts, stated, tables);
}

bool can_be_kept(const Category& object, Predicate relation, const Category& receptacle,
                 const std::set<std::string, std::less<>>& receptacle_affordances) {
  if (!object.movable || object.name == receptacle.name) return false;
  const bool inside = relation == Predicate::Inside;
  if (!receptacle_affordances.contains(inside ? "container" : "receptacle")) return false;
  if (inside && receptacle.archetype == Archetype::Drawers && !receptacle_affordances.contains("openable"))
    return false;
  return capacity_of(object, relation, receptacle) > 0;
}

void lay_under(const CompletedFacts& facts, const StatedFacts& stated, Tables& tables) {
  const auto categories = by_name(tables);
  const auto lacking = [&](FactKind kind, const std::string& category) -> Category* {
    const auto at = categories.find(category);
    return at == categories.end() || is_stated(stated, kind, category) ? nullptr : at->second;
  };
  for (const auto& f : facts.sizes) {
    if (auto* c = lacking(FactKind::Size, f.category)) c->size = f.size, c->size_source = f.source;
  }
  for (const auto& f : facts.masses) {
    if (auto* c = lacking(FactKind::Mass, f.category)) c->mass = f.mass, c->mass_source = f.source;
  }
  for (const auto& f : facts.synsets) {
    if (auto* c = lacking(FactKind::Synset, f.category)) c->synset = f.synset, c->synset_source = f.source;
  }
  for (const auto& f : facts.affordances) {
    if (lacking(FactKind::Affordances, f.category) != nullptr) tables.affordances.push_back(f);
  }
  lay_aliases(facts, stated, tables);
  lay_placements(facts, stated, tables);
  sort_tables(tables);
}

}  // namespace unietp
