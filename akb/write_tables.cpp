#include <algorithm>
#include <tuple>

#include "akb/csv_table.h"
#include "akb/tables.h"
#include "core/files.h"
#include "core/text.h"

namespace unietp {
namespace {

std::string flag_text(bool value) { return value ? "true" : "false"; }

std::vector<std::string> fields(const Category& c) {
  return {c.name,
          c.display,
          c.plural,
          c.synset,
          flag_text(c.countable),
          flag_text(c.movable),
          std::string(name_of(c.archetype)),
          number_text(c.size.x()),
          number_text(c.size.y()),
          number_text(c.size.z()),
          number_text(c.mass),
          join(c.rooms, "|"),
          join(c.colors, "|"),
          join(c.materials, "|"),
          c.source.source,
          number_text(c.source.confidence),
          c.size_source.source,
          number_text(c.size_source.confidence),
          c.mass_source.source,
          number_text(c.mass_source.confidence)};
}
std::vector<std::string> fields(const AffordanceFact& f) {
  return {f.category, f.affordance, f.source.source, number_text(f.source.confidence)};
}
std::vector<std::string> fields(const Placement& p) {
  return {p.object,
          std::string(info(p.relation).name),
          p.receptacle,
          number_text(p.likelihood),
          std::to_string(p.capacity),
          p.source.source,
          number_text(p.source.confidence)};
}
std::vector<std::string> fields(const Effect& e) {
  return {e.tool,          std::string(name_of(e.treatment)), e.target,
          e.gives,         std::to_string(e.amount),          join(names_of(e.needs), "|"),
          e.source.source, number_text(e.source.confidence)};
}
std::vector<std::string> fields(const Alias& a) {
  return {a.category, std::string(name_of(a.kind)), a.text, a.source.source, number_text(a.source.confidence)};
}
std::vector<std::string> fields(const Asset& a) {
  return {a.name,
          a.category,
          number_text(a.size.x()),
          number_text(a.size.y()),
          number_text(a.size.z()),
          a.source.source,
          number_text(a.source.confidence)};
}

template <class Row, class Key>
void sort_by(std::vector<Row>& rows, const Key& key) {
  const auto less = [&](const Row& a, const Row& b) { return key(a) < key(b); };
  if (!std::is_sorted(rows.begin(), rows.end(), less)) std::stable_sort(rows.begin(), rows.end(), less);
}

}  // namespace

void sort_tables(Tables& tables) {
  sort_by(tables.categories, [](const Category& c) { return std::tie(c.name); });
  sort_by(tables.affordances, [](const AffordanceFact& f) { return std::tie(f.category, f.affordance); });
  sort_by(tables.placements, [](const Placement& p) {
    return std::tuple(std::string_view(p.object), info(p.relation).name, std::string_view(p.receptacle));
  });
  sort_by(tables.effects, [](const Effect& e) {
    return std::tuple(std::string_view(e.tool), name_of(e.treatment), std::string_view(e.target),
                      std::string_view(e.gives));
  });
  sort_by(tables.aliases, [](const Alias& a) {
    return std::tuple(std::string_view(a.category), name_of(a.kind), std::string_view(a.text));
  });
  sort_by(tables.assets, [](const Asset& a) { return std::tie(a.category, a.name); });
}

std::string table_csv(const Tables& tables, std::string_view table) {
  const auto& columns = columns_of(table);
  if (table == "category") return csv_of(columns, tables.categories, fields);
  if (table == "affordance") return csv_of(columns, tables.affordances, fields);
  if (table == "relation") return csv_of(columns, tables.placements, fields);
  if (table == "effect") return csv_of(columns, tables.effects, fields);
  if (table == "alias") return csv_of(columns, tables.aliases, fields);
  return csv_of(columns, tables.assets, fields);
}

Result<Done> write_tables(const std::filesystem::path& folder, const Tables& tables) {
  for (const auto& table : table_names()) {
    auto written = write_file(folder / (table + ".csv"), table_csv(tables, table));
    if (!written) return written;
  }
  return Done{};
}

}  // namespace unietp
