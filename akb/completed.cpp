#include "akb/completed.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "akb/csv_table.h"
#include "akb/name_table.h"
#include "akb/row_reader.h"
#include "akb/table_words.h"
#include "core/files.h"
#include "core/limits.h"
#include "core/text.h"

namespace unietp {
namespace {

constexpr std::array kKinds{FactKind::Size,     FactKind::Mass,    FactKind::Synset,     FactKind::Aliases,
                            FactKind::Function, FactKind::Context, FactKind::Placements, FactKind::Affordances};
constexpr std::array<std::string_view, kKinds.size()> kNames{"size",     "mass",    "synset",     "aliases",
                                                             "function", "context", "placements", "affordances"};
constexpr std::array kFiles{"size", "mass", "synset", "affordance", "relation", "alias"};

bool is_stand_in(const Source& source) {
  return source.source.starts_with("derived:") && source.confidence < kLeastConfidence;
}

bool is_place(const Placement& p) { return p.relation == Predicate::On || p.relation == Predicate::Inside; }

const std::vector<std::string>& columns_of_file(std::string_view file) {
  static const std::vector<std::string> size{"category", "width", "depth", "height", "source", "confidence"};
  static const std::vector<std::string> mass{"category", "mass", "source", "confidence"};
  static const std::vector<std::string> synset{"category", "synset", "source", "confidence"};
  if (file == "size") return size;
  if (file == "mass") return mass;
  return file == "synset" ? synset : columns_of(file);
}

std::vector<std::string> fields(const CompletedFacts::Size& f) {
  return {f.category,      number_text(f.size.x()),         number_text(f.size.y()), number_text(f.size.z()),
          f.source.source, number_text(f.source.confidence)};
}
std::vector<std::string> fields(const CompletedFacts::Mass& f) {
  return {f.category, number_text(f.mass), f.source.source, number_text(f.source.confidence)};
}
std::vector<std::string> fields(const CompletedFacts::Synset& f) {
  return {f.category, f.synset, f.source.source, number_text(f.source.confidence)};
}

/// The file by category; "" for a table without rows, which has no file.
template <class Row>
std::string sorted_csv(std::string_view file, std::vector<Row> rows) {
  std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.category < b.category; });
  return rows.empty() ? "" : csv_of(columns_of_file(file), rows, fields);
}

}  // namespace

std::span<const FactKind> all_fact_kinds() { return kKinds; }
std::string_view name_of(FactKind kind) { return kNames[static_cast<std::size_t>(kind)]; }
std::optional<FactKind> fact_kind_named(std::string_view name) {
  const auto at = std::find(kNames.begin(), kNames.end(), name);
  if (at == kNames.end()) return std::nullopt;
  return kKinds[static_cast<std::size_t>(at - kNames.begin())];
}

FactKind kind_of(const Alias& alias) {
  switch (alias.kind) {
    case AliasKind::Synonym:
      return FactKind::Aliases;
    case AliasKind::Function:
      return FactKind::Function;
    case AliasKind::Context:
      return FactKind::Context;
    default:  // laid over the tables later
      return FactKind::Aliases;
  }
}

StatedFacts stated_by(const Tables& tables) {
  StatedFacts stated;
  for (const auto& c : tables.categories) {
    if (!is_stand_in(c.size_source)) stated[FactKind::Size].insert(c.name);
    if (!is_stand_in(c.mass_source)) stated[FactKind::Mass].insert(c.name);
    if (!c.synset.empty()) stated[FactKind::Synset].insert(c.name);
    if (!c.movable) stated[FactKind::Placements].insert(c.name);
  }
  for (const auto& f : tables.affordances) stated[FactKind::Affordances].insert(f.category);
  for (const auto& a : tables.aliases) stated[kind_of(a)].insert(a.category);
  for (const auto& p : tables.placements) {
    if (is_place(p)) stated[FactKind::Placements].insert(p.object);
  }
  return stated;
}

StatedFacts stated_by(const CompletedFacts& facts) {
  StatedFacts stated;
  for (const auto& f : facts.sizes) stated[FactKind::Size].insert(f.category);
  for (const auto& f : facts.masses) stated[FactKind::Mass].insert(f.category);
  for (const auto& f : facts.synsets) stated[FactKind::Synset].insert(f.category);
  for (const auto& f : facts.affordances) stated[FactKind::Affordances].insert(f.category);
  for (const auto& a : facts.aliases) stated[kind_of(a)].insert(a.category);
  for (const auto& p : facts.placements) stated[FactKind::Placements].insert(p.object);
  return stated;
}

bool is_stated(const StatedFacts& stated, FactKind kind, std::string_view category) {
  const auto of_kind = stated.find(kind);
  return of_kind != stated.end() && of_kind->second.contains(category);
}

std::filesystem::path completed_folder(const std::filesystem::path& tables, Simulator simulator) {
  return tables / "completed" / std::string(name_of(simulator));
}

std::filesystem::path removed_file(const std::filesystem::path& tables, Simulator simulator) {
  return tables / "curated" / std::string(name_of(simulator)) / "removed.csv";
}

std::vector<std::filesystem::path> completed_files(const std::filesystem::path& tables, Simulator simulator) {
  std::vector<std::filesystem::path> files;
  for (const char* file : kFiles) {
    auto path = completed_folder(tables, simulator) / (std::string(file) + ".csv");
    if (std::filesystem::exists(path)) files.push_back(std::move(path));
  }
  auto removed = removed_file(tables, simulator);
  if (!files.empty() && std::filesystem::exists(removed)) files.push_back(std::move(removed));
  return files;
}

CompletedFacts read_completed(const std::filesystem::path& folder, const Tables& known, std::vector<Error>& errors) {
  std::vector<std::string> all_names;
  for (const auto& c : known.categories) all_names.push_back(c.name);
  const NameTable names(std::move(all_names));
  CompletedFacts facts;
  const auto with_rows = [&](const char* file, const auto& read) {
    const auto path = folder / (std::string(file) + ".csv");
    if (!std::filesystem::exists(path)) return;
    const auto text = read_file(path);
    if (!text) {
      errors.push_back(text.error());
      return;
    }
    RowReader row(path.string(), *text, columns_of_file(file), errors);
    std::set<std::vector<std::string>> seen;
    for (const auto& cells : row.rows()) {
      row.at(cells);
      const auto key = read(row);
      if (row.sound() && !seen.insert(key).second)
        row.fail(columns_of_file(file).front(),
                 "row for '" + join(key, " ") + "' is duplicated; expected one row per key");
    }
  };
  const auto source = [](RowReader& row) {
    auto found = row.source("source", "confidence");
    if (row.sound() && !found.source.starts_with("llm:"))
      row.fail("source", "source '" + found.source + "' among completed facts; expected llm:<model>");
    return found;
  };
  using Key = std::vector<std::string>;
  const auto category = [&](RowReader& row) { return row.one_of("category", names, "category"); };
  with_rows("size", [&](RowReader& row) -> Key {
    CompletedFacts::Size f{
        category(row),
        {row.number("width", 0, limits::kCompleted_m, false), row.number("depth", 0, limits::kCompleted_m, false),
         row.number("height", 0, limits::kCompleted_m, false)},
        source(row)};
    if (row.sound()) facts.sizes.push_back(f);
    return {f.category};
  });
  with_rows("mass", [&](RowReader& row) -> Key {
    CompletedFacts::Mass f{category(row), row.number("mass", 0, limits::kCompleted_kg, false), source(row)};
    if (row.sound()) facts.masses.push_back(f);
    return {f.category};
  });
  with_rows("synset", [&](RowReader& row) -> Key {
    CompletedFacts::Synset f{category(row), row.required("synset"), source(row)};
    if (row.sound()) facts.synsets.push_back(f);
    return {f.category};
  });
  with_rows("affordance", [&](RowReader& row) -> Key {
    AffordanceFact f{category(row), row.one_of("affordance", affordance_names(), "affordance"), source(row)};
    if (row.sound()) facts.affordances.push_back(f);
    return {f.category, f.affordance};
  });
  with_rows("relation", [&](RowReader& row) -> Key {
    Placement p{row.one_of("object", names, "category"),
                row.value_of("relation", {"on", "inside"}, "relation", placement_relation_named),
                row.one_of("receptacle", names, "category"),
                row.number("likelihood", 0, 1, false),
                row.integer("capacity", 1),
                source(row)};
    if (row.sound()) facts.placements.push_back(p);
    return {p.object, std::string(info(p.relation).name), p.receptacle};
  });
  with_rows("alias", [&](RowReader& row) -> Key {
    Alias a{category(row), row.required("text"), read_alias_kind(row), source(row)};
    if (row.sound()) facts.aliases.push_back(a);
    return {a.category, std::string(name_of(a.kind)), a.text};
  });
  return facts;
}

Result<Done> write_completed(const std::filesystem::path& folder, CompletedFacts facts) {
  Tables tables;
  tables.affordances = std::move(facts.affordances);
  tables.placements = std::move(facts.placements);
  tables.aliases = std::move(facts.aliases);
  sort_tables(tables);
  const std::map<std::string, std::string> texts{
      {"size", sorted_csv("size", std::move(facts.sizes))},
      {"mass", sorted_csv("mass", std::move(facts.masses))},
      {"synset", sorted_csv("synset", std::move(facts.synsets))},
      {"affordance", tables.affordances.empty() ? "" : table_csv(tables, "affordance")},
      {"relation", tables.placements.empty() ? "" : table_csv(tables, "relation")},
      {"alias", tables.aliases.empty() ? "" : table_csv(tables, "alias")}};
  for (const auto& [file, text] : texts) {
    const auto path = folder / (file + ".csv");
    const bool there = std::filesystem::exists(path);
    if (text.empty() && !there) continue;
    if (text.empty()) {
      std::error_code code;
      std::filesystem::remove(path, code);
      if (code) return Error{Error::Kind::Io, path.string(), {}, "cannot remove it: " + code.message()};
      continue;
    }
    if (const auto old = there ? read_file(path) : Result<std::string>(std::string()); old && *old == text) continue;
    auto written = write_file(path, text);
    if (!written) return written;
  }
  return Done{};
}

}  // namespace unietp
