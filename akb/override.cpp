#include "akb/override.h"

#include <algorithm>
#include <set>

#include "akb/row_reader.h"
#include "core/text.h"

namespace unietp {
namespace {

const std::vector<std::string>& columns() {
  static const std::vector<std::string> names{"simulator", "category", "fact", "value", "reason"};
  return names;
}

std::vector<std::string> simulator_names() {
  std::vector<std::string> names;
  for (const auto simulator : kSimulators) names.emplace_back(name_of(simulator));
  return names;
}

}  // namespace

std::vector<std::filesystem::path> override_files(const std::filesystem::path& tables,
                                                  const std::vector<std::filesystem::path>& own) {
  std::vector<std::filesystem::path> files;
  if (std::error_code code; std::filesystem::exists(tables / "override.csv", code))
    files.push_back(tables / "override.csv");
  files.insert(files.end(), own.begin(), own.end());
  return files;
}

std::string override_source(const std::filesystem::path& file) {
  std::string name = file.filename().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }, '_');
  return "override:" + name;
}

std::vector<Override> read_overrides(const std::string& where, std::string_view text, std::vector<Error>& errors) {
  RowReader row(where, text, columns(), errors);
  const auto simulators = simulator_names();
  std::set<std::string> seen;
  std::vector<Override> overrides;
  for (const auto& cells : row.rows()) {
    row.at(cells);
    Override o;
    const auto simulator = row.one_of("simulator", simulators, "simulator");
    o.category = row.required("category");
    const auto fact = parse_fact(row.text("fact"));
    if (!fact) row.fail("fact", fact.error().message);
    o.value = row.text("value");
    o.reason = row.required("reason");
    o.category_at = row.place("category");
    o.fact_at = row.place("fact");
    o.value_at = row.place("value");
    if (!row.sound()) continue;
    const auto at = std::find(simulators.begin(), simulators.end(), simulator) - simulators.begin();
    o.simulator = kSimulators[static_cast<std::size_t>(at)];
    o.fact = *fact;
    if (!seen.insert(simulator + "\x1f" + o.category + "\x1f" + to_text(o.fact)).second) {
      row.fail("fact", "row for '" + simulator + " " + o.category + " " + to_text(o.fact) + "' twice; expected one");
      continue;
    }
    overrides.push_back(std::move(o));
  }
  return overrides;
}

}  // namespace unietp
