#include "interchange/format_facts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "akb/row_reader.h"
#include "akb/table_words.h"
#include "core/files.h"
#include "core/text.h"
#include "interchange/house_names.h"

namespace unietp {
namespace {

constexpr double kWidestFrame_m = 10, kLargestPrefab_m = 100;

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

std::vector<std::string> state_names() {
  std::vector<std::string> names;
  for (const StateGroup& group : state_groups()) {
    for (const Predicate state : group.predicates) names.emplace_back(info(state).name);
  }
  return names;
}

void read_virtualhome_words(const std::filesystem::path& folder, FormatFactsReading& reading) {
  FormatFacts& facts = reading.facts;
  std::vector<Error>& errors = reading.errors;
  read_table(folder / "virtualhome_rooms.csv", {"class", "room", "source"}, errors,
             [&](RowReader& row, std::string word) {
               facts.virtualhome_rooms.push_back({std::move(word), row.required("room")});
             });
  read_table(folder / "virtualhome_states.csv", {"word", "state", "source"}, errors,
             [&](RowReader& row, std::string word) {
               const auto state = row.value_of("state", state_names(), "state", predicate_named);
               facts.virtualhome_states.push_back({std::move(word), state});
             });
  read_table(folder / "virtualhome_properties.csv", {"property", "affordance", "source"}, errors,
             [&](RowReader& row, std::string word) {
               facts.virtualhome_properties.push_back(
                   {std::move(word), row.one_of("affordance", affordance_names(), "affordance")});
             });
  read_table(folder / "virtualhome_prefabs.csv", {"prefab", "class", "width_m", "depth_m", "height_m", "source"},
             errors, [&](RowReader& row, std::string name) {
               Prefab prefab{std::move(name)};
               if (!row.text("width_m").empty()) {
                 int axis = 0;
                 for (const char* const column : {"width_m", "depth_m", "height_m"})
                   prefab.size[axis++] = row.number(column, 0, kLargestPrefab_m, false);
               }
               facts.virtualhome_prefabs[row.required("class")].push_back(std::move(prefab));
             });
}

}  // namespace

FormatFactsReading read_format_facts(const std::filesystem::path& folder) {
  FormatFactsReading reading;
  FormatFacts& facts = reading.facts;
  std::vector<Error>& errors = reading.errors;
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
  read_virtualhome_words(folder, reading);
  read_table(folder / "virtualhome_faced.csv", {"class", "source"}, errors,
             [&](RowReader&, std::string name) { facts.virtualhome_faced.insert(std::move(name)); });
  read_table(folder / "building_words.csv", {"word", "source"}, errors,
             [&](RowReader&, std::string word) { facts.building_words.insert(std::move(word)); });
  read_table(folder / "procthor_lacks.csv", {"model", "lacks", "source"}, errors,
             [&](RowReader& row, std::string model) {
               auto& lacks = facts.model_lacks[std::move(model)];
               for (const std::string& name : split(row.required("lacks"), '|')) {
                 const auto& known = affordance_names();
                 if (std::find(known.begin(), known.end(), name) == known.end())
                   row.fail("lacks", "'" + name + "' is no affordance");
                 lacks.insert(name);
               }
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
