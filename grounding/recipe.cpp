#include <algorithm>
#include <charconv>
#include <set>

#include "akb/csv.h"
#include "core/files.h"
#include "core/text.h"
#include "grounding/layout.h"
#include "grounding/where.h"

namespace unietp {
namespace {

constexpr std::array<std::string_view, 6> kColumns{"room", "category", "at_least", "at_most", "where", "source"};
constexpr std::array<std::string_view, 7> kRoomTypes{"kitchen",     "living_room", "bedroom", "bathroom",
                                                     "dining_room", "office",      "corridor"};

Error schema(const std::string& file, SourcePos pos, std::string message) {
  return {Error::Kind::Schema, file, pos, std::move(message)};
}

std::optional<int> small_number(std::string_view text) {
  int value = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed != std::errc() || end != text.data() + text.size() || value < 0 || value > 20) return std::nullopt;
  return value;
}

/// What is wrong with one row, with the cell it stands in.
std::optional<Error> problem_of(const std::string& file, const CsvRow& row, const Knowledge& knowledge,
                                const std::set<std::string>& categories_so_far) {
  const auto at = [&](std::size_t cell, std::string message) {
    return schema(file, row[cell].pos, std::move(message));
  };
  if (std::find(kRoomTypes.begin(), kRoomTypes.end(), row[0].text) == kRoomTypes.end()) {
    return at(0, "unknown room type '" + row[0].text + "'; expected kitchen, living_room, bedroom, bathroom, " +
                     "dining_room, office or corridor");
  }
  const Category* category = knowledge.find(row[1].text);
  if (category == nullptr) {
    std::vector<std::string> names;
    for (const Category& one : knowledge.categories()) names.push_back(one.name);
    const std::string near = nearest_name(row[1].text, names);
    return at(1, "the knowledge base has no category '" + row[1].text + "'" +
                     (near.empty() ? "" : "; did you mean '" + near + "'?"));
  }
  if (category->movable) return at(1, "'" + row[1].text + "' is movable; a recipe lists furniture");
  const auto at_least = small_number(row[2].text), at_most = small_number(row[3].text);
  if (!at_least) return at(2, "expected a number from 0 to 20, got '" + row[2].text + "'");
  if (!at_most || *at_most < std::max(*at_least, 1)) {
    return at(3, "expected a number from at_least (and 1) to 20, got '" + row[3].text + "'");
  }
  const auto where = parse_where(row[4].text);
  if (!where) {
    return at(4,
              "expected wall, corner, centre, wall-hung[:metres], on:, at:, beside: or above:<category>[:metres], "
              "got '" +
                  row[4].text + "'");
  }
  if (!where->host.empty() && !categories_so_far.contains(row[0].text + "/" + where->host)) {
    return at(4, "'" + where->host + "' must be listed above for the same room");
  }
  if (row[5].text.empty()) return at(5, "a source is missing");
  return std::nullopt;
}

}  // namespace

std::optional<Where> parse_where(std::string_view text) {
  const auto parts = split(text, ':');
  Where where;
  std::size_t used = 1;
  const std::string& kind = parts.front();
  if (kind == "wall") {
    where.kind = Where::Kind::Wall;
  } else if (kind == "corner") {
    where.kind = Where::Kind::Corner;
  } else if (kind == "centre") {
    where.kind = Where::Kind::Centre;
  } else if (kind == "wall-hung") {
    where.kind = Where::Kind::WallHung;
  } else if (kind == "on" || kind == "at" || kind == "beside" || kind == "above") {
    where.kind = kind == "on"       ? Where::Kind::On
                 : kind == "at"     ? Where::Kind::At
                 : kind == "beside" ? Where::Kind::Beside
                                    : Where::Kind::Above;
    if (parts.size() < 2 || parts[1].empty()) return std::nullopt;
    where.host = parts[1];
    used = 2;
  } else {
    return std::nullopt;
  }
  if (parts.size() == used) return where;
  const bool takes_height = where.kind == Where::Kind::WallHung || where.kind == Where::Kind::Above;
  if (!takes_height || parts.size() != used + 1) return std::nullopt;
  double height = 0;
  const std::string& number = parts[used];
  const auto [end, failed] = std::from_chars(number.data(), number.data() + number.size(), height);
  if (failed != std::errc() || end != number.data() + number.size()) return std::nullopt;
  if (!(height >= 0 && height <= 2.5)) return std::nullopt;  // nan too
  where.height_m = height;
  return where;
}

Result<LayoutRecipe> load_recipe(const std::filesystem::path& folder, const Knowledge& knowledge) {
  const auto path = folder / (std::string(name_of(knowledge.simulator())) + ".csv");
  const auto text = read_file(path);
  if (!text) return text.error();
  const std::string file = path.filename().string();
  const CsvFile csv = read_csv(file, *text);
  if (!csv.errors.empty()) return csv.errors.front();
  bool same_columns = csv.header.size() == kColumns.size();
  for (std::size_t i = 0; same_columns && i < kColumns.size(); ++i) same_columns = csv.header[i].text == kColumns[i];
  if (!same_columns) return schema(file, {1, 1}, "expected the columns room,category,at_least,at_most,where,source");

  LayoutRecipe recipe;
  std::set<std::string> seen;
  for (const CsvRow& row : csv.rows) {
    if (auto problem = problem_of(file, row, knowledge, seen)) return *problem;
    seen.insert(row[0].text + "/" + row[1].text);
    recipe.furniture.push_back(
        {row[0].text, row[1].text, *small_number(row[2].text), *small_number(row[3].text), row[4].text});
    if (std::find(recipe.rooms.begin(), recipe.rooms.end(), row[0].text) == recipe.rooms.end()) {
      recipe.rooms.push_back(row[0].text);
    }
  }
  if (recipe.rooms.size() < 5) return schema(file, {1, 1}, "a recipe needs furniture for at least five room types");
  return recipe;
}

}  // namespace unietp
