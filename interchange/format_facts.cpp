#include "interchange/format_facts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "akb/row_reader.h"
#include "core/files.h"
#include "interchange/house_names.h"

namespace unietp {
namespace {

constexpr double kWidestFrame_m = 10;

/// Calls `take` for each row of a table whose first column is its key.
void read_table(const std::filesystem::path& file, const std::vector<std::string>& columns, std::vector<Error>& errors,
                const std::function<void(RowReader&, std::string)>& take) {
  const auto text = read_file(file);
  if (!text) {
    errors.push_back(text.error());
    return;
  }
  RowReader row(file.string(), *text, columns, errors);
  std::set<std::string> seen;
  for (const CsvRow& one : row.rows()) {
    row.at(one);
    auto key = row.required(columns.front());
    if (!seen.insert(key).second) row.fail(columns.front(), "'" + key + "' stands twice");
    (void)row.required("source");
    take(row, std::move(key));
  }
}

}  // namespace

FormatFactsReading read_format_facts(const std::filesystem::path& folder) {
  FormatFactsReading reading;
  auto& [facts, errors] = reading;
  read_table(folder / "replicacad_words.csv", {"word", "category", "source"}, errors,
             [&](RowReader& row, std::string word) {
               facts.replicacad_words.emplace(std::move(word), row.required("category"));
             });
  const auto doors = folder / "procthor_doors.csv";
  read_table(doors, {"model", "width_m", "height_m", "source"}, errors, [&](RowReader& row, std::string model) {
    const double width = row.number("width_m", 0, kWidestFrame_m, false);
    facts.door_models.push_back({std::move(model), width, row.number("height_m", 0, kWidestFrame_m, false)});
  });
  const auto floors = folder / "procthor_floors.csv";
  read_table(floors, {"room", "material", "source"}, errors, [&](RowReader& row, std::string room) {
    facts.floor_materials.emplace(std::move(room), row.required("material"));
  });
  if (!errors.empty()) return reading;
  if (facts.door_models.empty())
    errors.push_back({Error::Kind::Schema, doors.string(), {}, "is empty; expected at least one model"});
  for (const std::string_view room : kProcthorRooms) {
    if (!facts.floor_materials.contains(room))
      errors.push_back({Error::Kind::Schema, floors.string(), {}, "lacks a row for " + std::string(room)});
  }
  return reading;
}

const DoorModel& door_model_for(double width_m, const FormatFacts& facts) {
  return *std::min_element(facts.door_models.begin(), facts.door_models.end(),
                           [&](const DoorModel& a, const DoorModel& b) {
                             return std::abs(a.width - width_m) < std::abs(b.width - width_m);
                           });
}

}  // namespace unietp
