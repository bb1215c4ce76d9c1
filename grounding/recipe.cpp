#include "grounding/recipe.h"

#include <algorithm>
#include <set>

#include "akb/row_reader.h"
#include "akb/table_words.h"
#include "akb/tables.h"
#include "core/files.h"
#include "grounding/furniture_position.h"

namespace unietp {
namespace {

const std::vector<std::string> kRoomColumns{"room", "weight", "at_least", "at_most", "area_low", "area_high", "source"};
const std::vector<std::string> kFurnitureColumns{"room", "category", "mean", "at_least", "at_most", "where", "source"};
const std::vector<std::string> kObjectColumns{"room", "category", "mean", "source"};
const std::vector<std::string> kReceptacleColumns{"category", "mean", "source"};
const std::vector<std::string> kScaleColumns{"simulator", "fewest_rooms", "most_rooms", "objects_a_room", "source"};
constexpr double kMostOfAKind = 20, kMostArea_m2 = 80, kMostHeld = 200, kMostInARoom = 100;
constexpr std::size_t kRoomTypesOfAHome = 4;

class RecipeReader {
 public:
  explicit RecipeReader(const Knowledge& knowledge)
      : knowledge_(knowledge), simulator_(name_of(knowledge.simulator())) {
    for (const Category& category : knowledge.categories()) {
      (category.movable ? movable_ : furniture_).push_back(category.name);
    }
  }

  void rooms(std::string_view text) {
    each("_rooms.csv", text, kRoomColumns, [&](RowReader& row) {
      RoomRule rule;
      rule.type = row.one_of("room", room_types(), "room type");
      rule.weight = row.number("weight", 0, kMostOfAKind, false);
      rule.at_least = row.integer("at_least", 0);
      rule.at_most = row.integer("at_most", std::max(rule.at_least, 1));
      rule.area_low_m2 = row.number("area_low", 0, kMostArea_m2, false);
      rule.area_high_m2 = row.number("area_high", std::max(rule.area_low_m2, 0.0), kMostArea_m2, true);
      if (rule.at_most > kMostOfAKind) row.fail("at_most", "expected a whole number up to 20");
      if (!types_.insert(rule.type).second) row.fail("room", "'" + rule.type + "' occurs twice");
      recipe_.rooms.push_back(std::move(rule));
    });
  }

  void furniture(std::string_view text) {
    std::set<std::string> listed;
    each(".csv", text, kFurnitureColumns, [&](RowReader& row) {
      FurnitureRule rule;
      rule.room = room_of(row);
      rule.category = row.text("category");
      if (const Category* category = knowledge_.find(rule.category); category != nullptr && category->movable) {
        row.fail("category", "'" + rule.category + "' is movable; a recipe lists furniture");
      } else {
        row.one_of("category", furniture_, "piece of furniture");
      }
      rule.at_least = row.integer("at_least", 0);
      rule.at_most = row.integer("at_most", std::max(rule.at_least, 1));
      if (rule.at_most > kMostOfAKind) row.fail("at_most", "expected a whole number from at_least (and 1) to 20");
      rule.mean = row.number("mean", std::max(0, rule.at_least), kMostOfAKind, true);
      if (rule.mean > rule.at_most) row.fail("mean", "expected a number from at_least to at_most");
      rule.where = row.text("where");
      const auto where = parse_furniture_position(rule.where);
      if (!where) {
        row.fail("where",
                 "expected wall, run, corner, centre, ceiling, wall-hung[:metres], outer-wall[:metres], on:, at:, "
                 "beside:, before:, facing: or above:<category>[:metres], got '" +
                     rule.where + "'");
      } else if (!where->host.empty() && !listed.contains(rule.room + "/" + where->host)) {
        row.fail("where", "'" + where->host + "' must be listed above for the same room");
      }
      listed.insert(rule.room + "/" + rule.category);
      recipe_.furniture.push_back(std::move(rule));
    });
  }

  void objects(std::string_view text) {
    std::set<std::pair<std::string, std::string>> seen;
    each("_objects.csv", text, kObjectColumns, [&](RowReader& row) {
      if (row.text("room") == "any" && row.text("category") == "unseen") {
        recipe_.unseen_share = row.number("mean", 0, 1, true);
        return;
      }
      if (row.text("room") == "any" && row.text("category") == "floor") {
        recipe_.floor_share = row.number("mean", 0, 0.5, true);
        return;
      }
      if (row.text("room") == "any" && row.text("category") == "all") {
        recipe_.movable_share = row.number("mean", 0, 0.95, false);
        return;
      }
      ObjectRule rule{room_of(row), row.one_of("category", movable_, "movable category"),
                      row.number("mean", 0, kMostHeld, false)};
      if (!seen.insert({rule.room, rule.category}).second) row.fail("category", "is duplicated for the same room");
      recipe_.objects.push_back(std::move(rule));
    });
  }

  void receptacles(std::string_view text) {
    each("_receptacles.csv", text, kReceptacleColumns, [&](RowReader& row) {
      const std::string& name = row.text("category");
      if (knowledge_.find(name) == nullptr) {
        std::vector<std::string> all = furniture_;
        all.insert(all.end(), movable_.begin(), movable_.end());
        row.one_of("category", all, "category");
      }
      const double mean = row.number("mean", 0, kMostHeld, true);
      if (!recipe_.held.emplace(name, mean).second) row.fail("category", "'" + name + "' occurs twice");
    });
  }

  Result<LayoutRecipe> finish() {
    if (errors_.empty() && recipe_.rooms.size() < kRoomTypesOfAHome) {
      errors_.push_back({Error::Kind::Schema, simulator_ + "_rooms.csv", {1, 1}, "a home needs at least 4 room types"});
    }
    if (!errors_.empty()) return errors_.front();
    return std::move(recipe_);
  }

 private:
  template <class Read>
  void each(const std::string& suffix, std::string_view text, const std::vector<std::string>& columns,
            const Read& read) {
    RowReader reader(simulator_ + suffix, text, columns, errors_);
    for (const CsvRow& row : reader.rows()) {
      reader.at(row);
      read(reader);
      if (!well_formed_source(reader.text("source"))) {
        reader.fail("source", "expected metadata:<file>, derived:<rule>, llm:<model> or curated");
      }
    }
  }
  std::string room_of(RowReader& row) const {
    return row.one_of("room", {types_.begin(), types_.end()}, "room of this simulator");
  }

  const Knowledge& knowledge_;
  std::string simulator_;
  std::vector<std::string> furniture_, movable_;
  std::set<std::string> types_;
  LayoutRecipe recipe_;
  std::vector<Error> errors_;
};

/// What all simulators share.
Result<Done> add_common(const std::filesystem::path& folder, Simulator simulator, LayoutRecipe& recipe) {
  const auto doors = folder / "room_doors.csv", scales = folder / "home_scales.csv";
  const auto doors_text = read_file(doors), scales_text = read_file(scales);
  if (!doors_text) return doors_text.error();
  if (!scales_text) return scales_text.error();
  std::vector<Error> errors;
  recipe.doors = read_room_doors(doors.string(), *doors_text, errors);
  recipe.scale = read_home_scales(scales.string(), *scales_text, errors)[simulator];
  if (!errors.empty()) return errors.front();
  return Done{};
}

}  // namespace

std::map<Simulator, HomeScale> read_home_scales(std::string_view where, std::string_view text,
                                                std::vector<Error>& errors) {
  std::map<Simulator, HomeScale> scales;
  RowReader row(std::string(where), text, kScaleColumns, errors);
  for (const CsvRow& cells : row.rows()) {
    row.at(cells);
    const auto simulator = simulator_named(row.required("simulator"));
    if (!simulator) row.fail("simulator", "'" + row.text("simulator") + "' is not a simulator");
    HomeScale scale;
    scale.fewest_rooms = row.integer("fewest_rooms", 1);
    scale.most_rooms = row.integer("most_rooms", std::max(1, scale.fewest_rooms));
    scale.objects_a_room = row.number("objects_a_room", 0, kMostInARoom, false);
    row.required("source");
    if (simulator && !scales.emplace(*simulator, scale).second) row.fail("simulator", "stands twice");
  }
  for (const Simulator simulator : kSimulators)
    if (!scales.contains(simulator))
      errors.push_back({Error::Kind::Schema, std::string(where), {}, "no row for " + std::string(name_of(simulator))});
  return scales;
}

Result<LayoutRecipe> read_recipe(const RecipeTexts& texts, const Knowledge& knowledge) {
  RecipeReader reader(knowledge);
  reader.rooms(texts.rooms);
  reader.furniture(texts.furniture);
  reader.objects(texts.objects);
  reader.receptacles(texts.receptacles);
  return reader.finish();
}

Result<LayoutRecipe> load_recipe(const std::filesystem::path& folder, const Knowledge& knowledge) {
  const std::string name(name_of(knowledge.simulator()));
  RecipeTexts texts;
  const std::pair<const char*, std::string*> files[] = {{"_rooms.csv", &texts.rooms},
                                                        {".csv", &texts.furniture},
                                                        {"_objects.csv", &texts.objects},
                                                        {"_receptacles.csv", &texts.receptacles}};
  for (const auto& [suffix, content] : files) {
    auto text = read_file(folder / (name + suffix));
    if (!text) return text.error();
    *content = std::move(*text);
  }
  auto household = read_household(folder.parent_path() / "sense", knowledge);
  if (!household) return household.error();
  auto recipe = read_recipe(texts, knowledge);
  if (!recipe) return recipe;
  for (const ObjectRule& rule : recipe->objects) {
    if (rule.mean > 0) household->note_room(rule.category, rule.room);
  }
  recipe->household = std::make_shared<const Household>(std::move(*household));
  const auto added = add_common(folder, knowledge.simulator(), *recipe);
  if (!added) return added.error();
  return recipe;
}

}  // namespace unietp
