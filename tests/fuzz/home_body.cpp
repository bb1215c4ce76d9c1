#include <cmath>

#include "../annotator/small_knowledge.h"
#include "bodies.h"
#include "fuzz_bodies.h"
#include "grounding/furniture_position.h"
#include "grounding/layout_library.h"
#include "grounding/recipe.h"
#include "grounding/scene_statistics.h"
#include "simulation/profile.h"
#include "support.h"

namespace unietp::fuzz {

bool profile_body(std::string_view text) {
  static const Folder folder("profile");
  folder.write("ai2thor.json", text);
  const auto profile = load_profile(folder.path(), Simulator::Ai2thor);
  if (!profile) {
    check_error(profile.error());
    return false;
  }
  for (const double value : {profile->reach_m, profile->body_radius_m, profile->body_height_m, profile->camera_height_m,
                             profile->vertical_fov_deg, profile->sight_m, profile->step_m, profile->turn_deg,
                             profile->look_deg, profile->max_pick_mass_kg})
    require(std::isfinite(value) && value > 0);
  require(profile->hands > 0 && profile->image_width > 0 && profile->image_height > 0);
  return true;
}

namespace {

/// The small knowledge with things that move.
Knowledge knowledge_of_homes() {
  const Knowledge small = testing_support::small_knowledge();
  auto categories = small.categories();
  for (Category& category : categories) category.movable = category.name == "Mug" || category.name == "Apple";
  return Knowledge(small.simulator(), std::move(categories), {}, {}, {}, {});
}

}  // namespace

bool recipe_body(std::string_view text) {
  static const Knowledge knowledge = knowledge_of_homes();
  RecipeTexts texts;
  std::string doors, scales;
  for (std::string* table : {&texts.rooms, &texts.furniture, &texts.objects, &texts.receptacles, &doors, &scales}) {
    const std::size_t end = text.find("====\n");
    *table = text.substr(0, end);
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 5);
  }
  std::vector<Error> errors;
  for (const auto& [simulator, scale] : read_home_scales("home_scales.csv", scales, errors))
    require(!errors.empty() || (scale.fewest_rooms > 0 && scale.most_rooms >= scale.fewest_rooms));
  const RoomDoors read = read_room_doors("room_doors.csv", doors, errors);
  for (const auto& [room, other] : read.at_the_end) require(!room.empty() && !other.empty());
  for (const Error& error : errors) check_error(error);
  const auto recipe = read_recipe(texts, knowledge);
  if (!recipe) {
    check_error(recipe.error());
    return false;
  }
  for (const FurnitureRule& rule : recipe->furniture) {
    require(knowledge.find(rule.category) != nullptr);
    require(rule.at_least >= 0 && rule.mean >= rule.at_least && rule.at_most >= rule.mean);
    const auto where = parse_furniture_position(rule.where);
    require(where.has_value());
    require(!where->height_m || (*where->height_m >= 0 && *where->height_m <= 2.5));
  }
  for (const RoomRule& rule : recipe->rooms) require(rule.weight > 0 && rule.area_high_m2 >= rule.area_low_m2);
  for (const ObjectRule& rule : recipe->objects) require(knowledge.find(rule.category)->movable && rule.mean > 0);
  return true;
}

bool benchmark_body(std::string_view text) {
  const BenchmarkTable table = read_benchmark("benchmark.csv", text);
  for (const Error& error : table.errors) check_error(error);
  for (const BenchmarkLayout& layout : table.layouts) {
    require(!layout.id.empty() && layout.rooms >= 4 && layout.rooms <= 12);
    require(layout.objects >= 50 && layout.objects <= 600);
  }
  return table.errors.empty();
}

bool statistics_body(std::string_view text) {
  const auto statistics = statistics_from_json("statistics.json", text);
  if (!statistics) {
    check_error(statistics.error());
    return false;
  }
  const auto again = statistics_from_json("again.json", statistics_to_json(*statistics));
  require(again.operator bool());
  require(statistics_to_json(*again) == statistics_to_json(*statistics));
  for (const auto& [name, part] : parts_of(distance(*statistics, *again))) require(!part || *part >= -1e-9);
  require(!statistics_text(*statistics).empty());
  return true;
}

}  // namespace unietp::fuzz
