#include "akb/provenance.h"

#include <algorithm>

#include "akb/csv.h"
#include "akb/row_reader.h"
#include "core/files.h"
#include "scene/simulator.h"

namespace unietp {
namespace {

/// One row of a table whose columns decide what it is about.
class NamedCells {
 public:
  NamedCells(const CsvRow& header, const CsvRow& row) : header_(header), row_(row) {}
  /// "" for a column that the table lacks.
  std::string_view operator[](std::string_view column) const {
    for (std::size_t i = 0; i < header_.size(); ++i) {
      if (header_[i].text == column) return row_[i].text;
    }
    return "";
  }

 private:
  const CsvRow &header_, &row_;
};

bool says_property(const NamedCells& row, const Category& category, const FactName& fact) {
  const bool own = row["name"] == category.name, word = row["display"] == category.display && row["text"].empty();
  if (!own && !word) return false;
  if (fact.word == "size") return !row["width"].empty() || !row["depth"].empty() || !row["height"].empty();
  return !row[fact.word].empty();
}

bool removes(const NamedCells& row, const Category& category, const FactName& fact) {
  return row["subject"] == category.name && row["verb"] == fact.word &&
         (fact.object.empty() || row["object"] == fact.object || row["object"] == "*");
}

bool concerns(const NamedCells& row, const Category& category, const FactName& fact) {
  switch (fact.kind) {
    case FactName::Kind::Property:
      return says_property(row, category, fact);
    case FactName::Kind::Affordance:
      return (row["category"] == category.name && row["affordance"] == fact.word) || removes(row, category, fact);
    case FactName::Kind::Placement:
      return (row["object"] == category.name && row["relation"] == fact.word && row["receptacle"] == fact.object) ||
             removes(row, category, fact);
    case FactName::Kind::Effect:
      return row["tool"] == category.name && row["effect"] == fact.word && row["target"] == fact.object;
    case FactName::Kind::Alias:
      return row["text"] == fact.object && (row["category"] == category.name || row["display"] == category.display);
    case FactName::Kind::Asset:
      return row["asset"] == fact.object;
  }
  return false;
}

/// The CSV files right inside a folder, by name.
std::vector<std::filesystem::path> tables_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code code;
  for (auto it = std::filesystem::directory_iterator(folder, code);
       !code && it != std::filesystem::directory_iterator(); it.increment(code)) {
    if (it->path().extension() == ".csv") files.push_back(it->path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<License> read_licenses(const std::filesystem::path& file, std::vector<Error>& errors) {
  const auto text = read_file(file);
  if (!text) {
    errors.push_back(text.error());
    return {};
  }
  std::vector<License> licenses;
  RowReader row(file.string(), *text, {"source", "origin", "licence"}, errors);
  for (const auto& cells : row.rows()) {
    row.at(cells);
    License license{row.required("source"), row.required("origin"), row.required("licence")};
    if (row.sound()) licenses.push_back(std::move(license));
  }
  return licenses;
}

std::optional<License> license_of(const std::vector<License>& licenses, std::string_view source) {
  std::optional<License> best;
  for (const auto& license : licenses) {
    if (source.starts_with(license.prefix) && (!best || license.prefix.size() > best->prefix.size())) best = license;
  }
  return best;
}

std::vector<RuleMeaning> read_rules(const std::filesystem::path& file, std::vector<Error>& errors) {
  const auto text = read_file(file);
  if (!text) {
    errors.push_back(text.error());
    return {};
  }
  std::vector<RuleMeaning> rules;
  RowReader row(file.string(), *text, {"rule", "meaning"}, errors);
  for (const auto& cells : row.rows()) {
    row.at(cells);
    RuleMeaning rule{row.required("rule"), row.required("meaning")};
    if (row.sound()) rules.push_back(std::move(rule));
  }
  return rules;
}

std::optional<std::string> meaning_of(const std::vector<RuleMeaning>& rules, std::string_view source) {
  for (const auto& rule : rules) {
    if (source == "derived:" + rule.rule) return rule.meaning;
  }
  return std::nullopt;
}

std::vector<CuratedRow> curated_rows(const std::filesystem::path& curated, Simulator simulator,
                                     const Category& category, const FactName& fact) {
  std::vector<CuratedRow> found;
  for (const auto& folder : {curated, curated / std::string(name_of(simulator))}) {
    for (const auto& file : tables_in(folder)) {
      const auto text = read_file(file);
      if (!text) continue;
      const auto table = read_csv(file.string(), *text);
      for (const auto& row : table.rows) {
        if (concerns(NamedCells(table.header, row), category, fact))
          found.push_back({file.lexically_relative(curated).generic_string(), row.front().pos.line});
      }
    }
  }
  return found;
}

}  // namespace unietp
