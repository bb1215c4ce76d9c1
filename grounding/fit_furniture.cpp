#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>

#include "akb/row_reader.h"
#include "akb/table_words.h"
#include "akb/tables.h"
#include "core/files.h"
#include "core/text.h"
#include "grounding/furniture_position.h"
#include "grounding/layout_fit.h"

namespace unietp {
namespace {

constexpr double kRare = 0.04;                // pieces that fewer rooms have are left out
constexpr double kAlways = 0.9;               // a share of rooms above which a piece is obligatory
constexpr double kLargestFittedArea_m2 = 36;  // larger rooms would put most of a home out of the agent's sight
constexpr double kSmallestArea_m2 = 9;

const std::vector<std::string> kFittedFurnitureColumns{"room", "category", "where",  "share",
                                                       "mean", "at_least", "at_most"};
const std::vector<std::string> kFittedRoomColumns{"room", "weight", "at_least", "at_most", "area_low", "area_high"};

struct Curated {
  std::string room, category, where;
  double share = 1;
  std::optional<double> mean;
  int at_least = 0, at_most = 1;
};

/// How often a category was seen in the rooms of a type.
struct Frequency {
  double mean = 0;
  double share = 0;  // of the rooms that have it
  int most = 0;      // in one room
};

Frequency frequency_in(const FitInput& own, const std::string& room, const std::string& category) {
  Frequency seen;
  int rooms = 0, total = 0, with = 0;
  for (const HomeCensus& home : own.homes.homes) {
    for (const CensusRoom& one : home.rooms) {
      if (one.type != room) continue;
      ++rooms;
      const auto count = static_cast<int>(std::count_if(
          one.objects.begin(), one.objects.end(), [&](const auto& object) { return object.category == category; }));
      total += count;
      with += count > 0 ? 1 : 0;
      seen.most = std::max(seen.most, count);
    }
  }
  if (rooms > 0) {
    seen.mean = static_cast<double>(total) / rooms;
    seen.share = static_cast<double>(with) / rooms;
  }
  return seen;
}

Result<std::vector<Curated>> read_curated(const FitInput& own, const std::filesystem::path& folder) {
  const std::string name = std::string(name_of(own.knowledge->simulator())) + ".csv";
  const auto text = read_file(folder / name);
  if (!text) return text.error();
  std::vector<Error> errors;
  RowReader reader("curated/" + name, *text, kFittedFurnitureColumns, errors);
  auto rooms = room_types();
  rooms.emplace_back("any");
  std::vector<std::string> furniture;
  for (const Category& category : own.knowledge->categories()) {
    if (!category.movable) furniture.push_back(category.name);
  }
  std::vector<Curated> rows;
  for (const CsvRow& row : reader.rows()) {
    reader.at(row);
    Curated one;
    one.room = reader.one_of("room", rooms, "room type");
    one.category = reader.one_of("category", furniture, "piece of furniture");
    one.where = reader.required("where");
    if (!one.where.empty() && !parse_furniture_position(one.where)) reader.fail("where", "not a place for furniture");
    if (!reader.text("share").empty()) one.share = reader.number("share", 0, 1, false);
    if (!reader.text("mean").empty()) one.mean = reader.number("mean", 0, 20, false);
    if (!reader.text("at_least").empty()) one.at_least = reader.integer("at_least", 0);
    one.at_most = reader.integer("at_most", 1);
    rows.push_back(std::move(one));
  }
  if (!errors.empty()) return errors.front();
  return rows;
}

/// The lower and the upper one.
std::pair<double, double> quartiles(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {values[values.size() / 4], values[3 * values.size() / 4]};
}

}  // namespace

Result<std::string> fit_furniture(const FitInput& own, const std::filesystem::path& curated) {
  const auto rows = read_curated(own, curated);
  if (!rows) return rows.error();
  std::string out = "room,category,mean,at_least,at_most,where,source\n";
  for (const std::string& room : room_types()) {
    std::set<std::string> special;  // categories that this room has rows of its own for
    for (const Curated& row : *rows) {
      if (row.room == room) special.insert(row.category);
    }
    std::set<std::string> listed, obligatory;
    for (const Curated& row : *rows) {
      if (row.room != room && (row.room != "any" || special.contains(row.category))) continue;
      const std::string host = parse_furniture_position(row.where)->host;
      if (!host.empty() && !listed.contains(host)) continue;
      double mean = 0;
      int at_least = row.at_least, at_most = row.at_most;
      std::string source = "curated";
      if (row.mean) {
        mean = *row.mean;
      } else {
        const Frequency seen = frequency_in(own, room, row.category);
        mean = seen.mean * row.share;
        if (mean < kRare) continue;
        at_most = std::min(at_most, std::max(1, static_cast<int>(std::ceil(seen.most * row.share))));
        mean = std::min(mean, static_cast<double>(at_most));
        const bool has_host = host.empty() || obligatory.contains(host);
        if (seen.share >= kAlways && mean >= kAlways && has_host) at_least = std::max(at_least, 1);
        source = own.homes.source;
      }
      mean = std::max(mean, static_cast<double>(at_least));
      listed.insert(row.category);
      if (at_least > 0) obligatory.insert(row.category);
      out += csv_line({room, row.category, rounded_text(mean), std::to_string(at_least), std::to_string(at_most),
                       row.where, source});
    }
  }
  return out;
}

Result<std::string> fit_rooms(const FitInput& own, const std::filesystem::path& curated) {
  const std::string name = std::string(name_of(own.knowledge->simulator())) + "_rooms.csv";
  const auto text = read_file(curated / name);
  if (!text) return text.error();
  std::vector<Error> errors;
  RowReader reader("curated/" + name, *text, kFittedRoomColumns, errors);
  std::string out = "room,weight,at_least,at_most,area_low,area_high,source\n";
  for (const CsvRow& row : reader.rows()) {
    reader.at(row);
    const std::string room = reader.one_of("room", room_types(), "room type");
    const int at_least = reader.integer("at_least", 0), at_most = reader.integer("at_most", 1);
    std::vector<double> areas;
    for (const HomeCensus& home : own.homes.homes) {
      for (const CensusRoom& one : home.rooms) {
        if (one.type == room && !one.outline.empty()) areas.push_back(floor_area(one));
      }
    }
    double low = 0, high = 0;
    if (!reader.text("area_low").empty() || areas.empty()) {
      low = reader.number("area_low", 0, kLargestFittedArea_m2, false);
      high = reader.number("area_high", low, kLargestFittedArea_m2, true);
    } else {
      std::tie(low, high) = quartiles(areas);
      low = std::clamp(low, kSmallestArea_m2, 0.7 * kLargestFittedArea_m2);
      high = std::clamp(high, low, kLargestFittedArea_m2);
    }
    double weight = 0;
    std::string source = "curated";
    const auto seen = own.statistics.rooms_of_type.find(room);
    if (reader.text("weight").empty() && seen != own.statistics.rooms_of_type.end()) {
      weight = seen->second;
      source = own.homes.room_source;
    } else {
      weight = reader.number("weight", 0, 10, false);
    }
    if (!errors.empty()) return errors.front();
    out += csv_line({room, rounded_text(weight), std::to_string(at_least), std::to_string(at_most),
                     rounded_text(low, 10), rounded_text(high, 10), source});
  }
  if (!errors.empty()) return errors.front();
  return out;
}

}  // namespace unietp
