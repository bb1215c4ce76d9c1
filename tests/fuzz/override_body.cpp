#include <cstdio>

#include "akb/override.h"

#include "akb/tables.h"
#include "bodies.h"
#include "fuzz_bodies.h"
#include "support.h"

namespace unietp::fuzz {
namespace {

/// A mug, a plate to put it on, a fridge that cools it, in every simulator.
std::vector<Tables> small_homes() {
  const Source curated{"curated", 1};
  Tables tables;
  for (const char* name : {"fridge", "mug", "plate"}) {
    Category c;
    c.name = c.display = name;
    c.plural = c.name + "s";
    c.movable = c.name != "fridge";
    c.size = {0.1, 0.1, 0.1};
    c.mass = 0.3;
    c.source = c.size_source = c.mass_source = c.synset_source = curated;
    tables.categories.push_back(std::move(c));
  }
  tables.affordances = {{"mug", "pickupable", curated}};
  tables.placements = {{"mug", Predicate::On, "plate", 1, 2, curated}};
  tables.effects = {{"fridge", Treatment::Cools, "mug", "", 0, {EffectNeed::Closed}, curated}};
  tables.aliases = {{"mug", "cup", AliasKind::Synonym, curated}};
  tables.assets = {{"Mug_1", "mug", {0.1, 0.1, 0.1}, curated}};
  return std::vector<Tables>(kSimulators.size(), tables);
}

}  // namespace

bool override_body(std::string_view text) {
  std::vector<Error> errors;
  const auto overrides = read_overrides("own.csv", text, errors);
  for (const Override& o : overrides) {
    const auto again = parse_fact(to_text(o.fact));
    require(again && *again == o.fact);
  }
  auto all = small_homes();
  apply_overrides("own.csv", overrides, all, errors);
  for (const Error& error : errors) check_error(error);
  if (!errors.empty()) return false;

  // What an override makes of sound tables is sound again.
  static const Folder folder("override");
  for (auto& tables : all) {
    sort_tables(tables);
    for (const std::string& table : table_names()) folder.write(table + ".csv", table_csv(tables, table));
    const auto again = read_tables(folder.path(), errors);
    for (const Error& error : errors) (void)std::fprintf(stderr, "%s\n", format(error).c_str());
    require(errors.empty());
    for (const std::string& table : table_names()) require(table_csv(again, table) == table_csv(tables, table));
  }
  return true;
}

}  // namespace unietp::fuzz
