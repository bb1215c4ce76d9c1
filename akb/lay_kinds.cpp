#include "akb/lay_kinds.h"

#include <algorithm>
#include <map>
#include <set>

#include "akb/category_words.h"
#include "akb/csv.h"
#include "akb/row_reader.h"
#include "core/files.h"
#include "core/text.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

fs::path sense_of(const fs::path& tables) { return tables.parent_path() / "sense"; }

std::optional<std::string> text_of(const fs::path& file, std::vector<Error>& errors) {
  std::error_code code;
  if (!fs::exists(file, code)) return std::nullopt;
  auto text = read_file(file);
  if (text) return std::move(*text);
  errors.push_back(text.error());
  return std::nullopt;
}

/// Some columns of a table, which may have others; the sense room checks the whole.
std::vector<std::vector<std::string>> columns_in(const fs::path& file, const std::vector<std::string>& names,
                                                 std::vector<Error>& errors) {
  const auto text = text_of(file, errors);
  if (!text) return {};
  const auto csv = read_csv(file.string(), *text);
  errors.insert(errors.end(), csv.errors.begin(), csv.errors.end());
  std::vector<std::size_t> places;
  for (const auto& name : names) {
    const auto found =
        std::find_if(csv.header.begin(), csv.header.end(), [&](const CsvCell& cell) { return cell.text == name; });
    if (found == csv.header.end()) {
      errors.push_back({Error::Kind::Schema, file.string(), {1, 1}, "the column '" + name + "' is missing"});
      return {};
    }
    places.push_back(static_cast<std::size_t>(found - csv.header.begin()));
  }
  std::vector<std::vector<std::string>> rows;
  for (const auto& row : csv.rows) {
    auto& cells = rows.emplace_back();
    for (const auto place : places) cells.push_back(row[place].text);
  }
  return rows;
}

/// Each kind with all wider ones, narrowest first. A circle, which the sense room reports, is cut.
std::map<std::string, std::vector<std::string>> lineages(const fs::path& tables, std::vector<Error>& errors) {
  std::map<std::string, std::string> parents;
  for (const auto& row : columns_in(sense_of(tables) / "kinds.csv", {"name", "parent"}, errors))
    parents.emplace(row[0], row[1]);
  std::map<std::string, std::vector<std::string>> lines;
  for (const auto& [kind, parent] : parents) {
    auto& line = lines[kind];
    for (auto at = parents.find(kind); at != parents.end() && line.size() <= parents.size();
         at = parents.find(at->second))
      line.push_back(at->first);
  }
  return lines;
}

/// A row of functions.csv: what something is for.
struct FunctionRow {
  std::string name;
  std::vector<std::string> phrases, kinds, also, except;
};

bool has(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

template <class Row>
bool serves(const Category& category, const Row& row) {
  if (names_category(row.except, category)) return false;
  return names_category(row.also, category) ||
         std::any_of(row.kinds.begin(), row.kinds.end(), [&](const auto& kind) { return has(category.kinds, kind); });
}

/// Reports words of the columns kinds, also and except that name no kind or no category.
void check_words(RowReader& row, const std::map<std::string, std::vector<std::string>>& kinds,
                 const std::vector<Tables>& all) {
  for (const auto& kind : row.list("kinds")) {
    if (!kinds.contains(kind)) row.fail("kinds", "'" + kind + "' is not a kind of kinds.csv");
  }
  for (const auto* column : {"also", "except"}) {
    for (const auto& word : row.list(column)) {
      if (!names_any_category(word, all)) row.fail(column, "no simulator has a category that is called '" + word + "'");
    }
  }
}

/// Whether the tables have the same phrase of the category, from another source.
bool is_stated(const Alias& alias, const Tables& tables) {
  return std::any_of(tables.aliases.begin(), tables.aliases.end(), [&](const Alias& other) {
    return other.category == alias.category && other.kind == alias.kind && other.text == alias.text;
  });
}

std::vector<FunctionRow> read_functions(const fs::path& file,
                                        const std::map<std::string, std::vector<std::string>>& kinds,
                                        std::vector<Tables>& all, std::vector<Error>& errors) {
  const auto text = text_of(file, errors);
  if (!text) return {};
  RowReader row(file.string(), *text, {"function", "phrases", "kinds", "also", "except", "source"}, errors);
  std::vector<FunctionRow> functions;
  std::set<std::string> seen;
  for (const auto& cells : row.rows()) {
    row.at(cells);
    FunctionRow function{row.required("function"), row.list("phrases"), row.list("kinds"), row.list("also"),
                         row.list("except")};
    (void)row.required("source");
    if (function.phrases.empty()) row.fail("phrases", "expected at least one phrase, such as 'something to read'");
    for (const auto& phrase : function.phrases) {
      if (!seen.insert(phrase).second) row.fail("phrases", "'" + phrase + "' stands twice");
    }
    check_words(row, kinds, all);
    const bool served = std::any_of(all.begin(), all.end(), [&](const Tables& tables) {
      return std::any_of(tables.categories.begin(), tables.categories.end(),
                         [&](const Category& category) { return serves(category, function); });
    });
    if (row.sound() && !served) row.fail("function", "no simulator has a category that serves as this");
    if (row.sound()) functions.push_back(std::move(function));
  }
  return functions;
}

/// A row of kind_traits.csv.
struct TraitRow {
  KindTrait trait = KindTrait::OneSize;
  std::vector<std::string> kinds, also, except;
};

/// Every trait has exactly one row, but where there is no table.
std::vector<TraitRow> read_traits(const fs::path& file, const std::map<std::string, std::vector<std::string>>& kinds,
                                  const std::vector<Tables>& all, std::vector<Error>& errors) {
  const auto text = text_of(file, errors);
  if (!text) return {};
  std::vector<std::string> names;
  for (const KindTrait trait : kKindTraits) names.emplace_back(name_of(trait));
  RowReader row(file.string(), *text, {"trait", "kinds", "also", "except", "source"}, errors);
  std::vector<TraitRow> traits;
  std::set<KindTrait> seen;
  for (const auto& cells : row.rows()) {
    row.at(cells);
    const TraitRow read{row.value_of("trait", names, "trait", kind_trait_named), row.list("kinds"), row.list("also"),
                        row.list("except")};
    (void)row.required("source");
    check_words(row, kinds, all);
    if (row.sound() && !seen.insert(read.trait).second) row.fail("trait", "stands twice");
    if (row.sound()) traits.push_back(read);
  }
  for (const KindTrait trait : kKindTraits) {
    if (errors.empty() && !seen.contains(trait))
      errors.push_back({Error::Kind::Schema, file.string(), {}, "no row of '" + std::string(name_of(trait)) + "'"});
  }
  std::sort(traits.begin(), traits.end(), [](const TraitRow& a, const TraitRow& b) { return a.trait < b.trait; });
  return traits;
}

}  // namespace

std::vector<fs::path> kind_files(const fs::path& tables) {
  std::vector<fs::path> files;
  for (const auto* name : {"kinds.csv", "categories.csv", "kind_traits.csv", "functions.csv", "phrases.csv"}) {
    std::error_code code;
    if (auto file = sense_of(tables) / name; fs::exists(file, code)) files.push_back(std::move(file));
  }
  return files;
}

void lay_kinds(const fs::path& tables, std::vector<Tables>& all, std::vector<Error>& errors) {
  const auto kinds = lineages(tables, errors);
  std::map<std::pair<std::string, std::string>, std::string> kind_of;
  for (auto& row : columns_in(sense_of(tables) / "categories.csv", {"simulator", "category", "kind"}, errors))
    kind_of.emplace(std::pair(row[0], row[1]), row[2]);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (auto& category : all[i].categories) {
      const auto known = kind_of.find({std::string(name_of(kSimulators[i])), category.name});
      const auto line = known == kind_of.end() ? kinds.end() : kinds.find(known->second);
      if (line != kinds.end()) category.kinds = line->second;
    }
  }
  for (const auto& row : read_traits(sense_of(tables) / "kind_traits.csv", kinds, all, errors)) {
    for (auto& simulator : all) {
      for (auto& category : simulator.categories) {
        if (serves(category, row)) category.traits.push_back(row.trait);
      }
    }
  }
  for (const auto& function : read_functions(sense_of(tables) / "functions.csv", kinds, all, errors)) {
    for (auto& simulator : all) {
      for (const auto& category : simulator.categories) {
        if (!serves(category, function)) continue;
        for (const auto& phrase : function.phrases) {
          Alias alias{category.name, phrase, AliasKind::Function, {"derived:function:" + function.name, 1}};
          if (!is_stated(alias, simulator)) simulator.aliases.push_back(std::move(alias));
        }
      }
    }
  }
}

}  // namespace unietp
