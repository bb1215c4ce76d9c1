#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "core/text.h"
#include "grounding/scene_statistics.h"
#include "scene/json_parse.h"
#include "scene/json_reader.h"

namespace unietp {
namespace {

constexpr std::string_view kFormat = "unietp-scene-statistics/1";

double rounded(double value) { return std::round(value * 1e4) / 1e4; }
std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

void append(std::string& out, std::string_view name, const std::map<std::string, double>& values) {
  out += ",\n\"" + std::string(name) + "\": [";
  bool first = true;
  for (const auto& [key, value] : values) {
    out += (first ? "\n[" : ",\n[") + quoted(key) + ", " + number_text(rounded(value)) + "]";
    first = false;
  }
  out += "]";
}

void append(std::string& out, std::string_view name, const std::map<SceneStatistics::Pair, double>& values) {
  out += ",\n\"" + std::string(name) + "\": [";
  bool first = true;
  for (const auto& [key, value] : values) {
    out += (first ? "\n[" : ",\n[") + quoted(key.first) + ", " + quoted(key.second) + ", " +
           number_text(rounded(value)) + "]";
    first = false;
  }
  out += "]";
}

/// Reads [["kitchen", 1.5], …]: names and a number that is not negative.
class TableReader {
 public:
  TableReader(JsonReader& reader, JsonFields& fields) : reader_(reader), fields_(fields) {}

  void read(std::string_view name, std::map<std::string, double>& values) {
    each(name, 2,
         [&](const JsonAt& row) { values[reader_.text(reader_.item(row, 0))] = amount(reader_.item(row, 1)); });
  }
  void read(std::string_view name, std::map<SceneStatistics::Pair, double>& values) {
    each(name, 3, [&](const JsonAt& row) {
      const std::string first = reader_.text(reader_.item(row, 0)), second = reader_.text(reader_.item(row, 1));
      values[{first, second}] = amount(reader_.item(row, 2));
    });
  }
  void read(std::string_view name, double& value) {
    if (const auto at = fields_.required(name)) value = amount(*at);
  }
  void read(std::string_view name, int& value) {
    double number = 0;
    read(name, number);
    if (number > 1e9) return reader_.fail("/" + std::string(name), "expected a whole number up to 1000000000");
    if (number >= 0) value = static_cast<int>(number);
  }

 private:
  double amount(const JsonAt& at) {
    const double value = reader_.number(at);
    if (value < 0) reader_.fail(at, "expected a number that is not negative");
    return value;
  }
  template <class Read>
  void each(std::string_view name, std::size_t width, const Read& read) {
    const auto table = fields_.required(name);
    if (!table) return;
    const std::size_t rows = reader_.items(*table);
    for (std::size_t i = 0; i < rows && !reader_.error(); ++i) {
      const JsonAt row = reader_.item(*table, i);
      if (reader_.items(row) != width) {
        return reader_.fail(row, "expected a list of " + std::to_string(width) + ": names, then a number");
      }
      read(row);
    }
  }

  JsonReader& reader_;
  JsonFields& fields_;
};

std::string column(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%8.2f", value);
  return text.data();
}

void append_means(std::string& out, const SceneStatistics& s, const std::string& type,
                  const std::map<SceneStatistics::Pair, double>& means) {
  constexpr std::size_t kShown = 12;
  std::vector<std::pair<double, std::string>> rows;
  for (const auto& [key, mean] : means) {
    if (key.first == type) rows.emplace_back(-mean, key.second);
  }
  std::sort(rows.begin(), rows.end());
  if (rows.empty()) return;
  out += &means == &s.furniture ? "  furniture:    " : "  small things: ";
  for (std::size_t i = 0; i < std::min(kShown, rows.size()); ++i) {
    out += (i ? ", " : "") + rows[i].second + " " + number_text(std::round(-rows[i].first * 100) / 100);
  }
  if (rows.size() > kShown) out += ", and " + std::to_string(rows.size() - kShown) + " more";
  out += "\n";
}

}  // namespace

std::string statistics_to_json(const SceneStatistics& s) {
  std::string out = "{\n\"format\": \"" + std::string(kFormat) + "\",\n\"source\": " + quoted(s.source);
  const auto number = [&](std::string_view name, double value) {
    out += ",\n\"" + std::string(name) + "\": " + number_text(rounded(value));
  };
  number("homes", s.homes);
  number("rooms", s.rooms);
  number("objects", s.objects);
  number("rooms_per_home", s.rooms_per_home);
  number("objects_per_home", s.objects_per_home);
  number("movable_share", s.movable_share);
  append(out, "rooms_of_type", s.rooms_of_type);
  append(out, "objects_in", s.objects_in);
  append(out, "area_m2", s.area_m2);
  append(out, "free_floor", s.free_floor);
  append(out, "furniture", s.furniture);
  append(out, "movables", s.movables);
  append(out, "together", s.together);
  append(out, "held", s.held);
  return out + "\n}\n";
}

Result<SceneStatistics> statistics_from_json(std::string_view where, std::string_view text) {
  const auto json = parse_json(where, text);
  if (!json) return json.error();
  JsonReader reader(where);
  const JsonAt root{*json};
  JsonFields fields(reader, root);
  SceneStatistics s;
  if (const auto format = fields.required("format"); format && reader.text(*format) != kFormat) {
    reader.fail(*format, "expected " + std::string(kFormat));
  }
  if (const auto source = fields.required("source")) s.source = reader.text(*source);
  TableReader table(reader, fields);
  table.read("homes", s.homes);
  table.read("rooms", s.rooms);
  table.read("objects", s.objects);
  table.read("rooms_per_home", s.rooms_per_home);
  table.read("objects_per_home", s.objects_per_home);
  table.read("movable_share", s.movable_share);
  table.read("rooms_of_type", s.rooms_of_type);
  table.read("objects_in", s.objects_in);
  table.read("area_m2", s.area_m2);
  table.read("free_floor", s.free_floor);
  table.read("furniture", s.furniture);
  table.read("movables", s.movables);
  table.read("together", s.together);
  table.read("held", s.held);
  fields.finish();
  if (reader.error()) return *reader.error();
  return s;
}

std::string statistics_text(const SceneStatistics& s) {
  std::string out = s.source + ": " + std::to_string(s.homes) + " homes, " + std::to_string(s.rooms) + " rooms, " +
                    std::to_string(s.objects) + " objects\n" + column(s.rooms_per_home) + " rooms a home\n" +
                    column(s.objects_per_home) + " objects a home, " + column(100 * s.movable_share) + " % movable\n\n";
  for (const auto& [type, count] : s.rooms_of_type) {
    out += type + "\n" + column(count) + " a home";
    if (const auto each = s.objects_in.find(type); each != s.objects_in.end()) {
      out += "," + column(each->second) + " objects each";
    }
    if (const auto area = s.area_m2.find(type); area != s.area_m2.end()) out += "," + column(area->second) + " m2";
    if (const auto share = s.free_floor.find(type); share != s.free_floor.end()) {
      out += "," + column(100 * share->second) + " % of the floor free";
    }
    out += "\n";
    append_means(out, s, type, s.furniture);
    append_means(out, s, type, s.movables);
  }
  return out;
}

}  // namespace unietp
