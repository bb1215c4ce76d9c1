#include <cmath>

#include "../annotator/small_knowledge.h"
#include "bodies.h"
#include "fuzz_bodies.h"
#include "grounding/layout.h"
#include "grounding/where.h"
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

bool recipe_body(std::string_view text) {
  static const Folder folder("recipe");
  static const Knowledge knowledge = testing_support::small_knowledge();
  folder.write("ai2thor.csv", text);
  const auto recipe = load_recipe(folder.path(), knowledge);
  if (!recipe) {
    check_error(recipe.error());
    return false;
  }
  for (const FurnitureRule& rule : recipe->furniture) {
    require(knowledge.find(rule.category) != nullptr);
    require(rule.at_least >= 0 && rule.at_most >= rule.at_least);
    const auto where = parse_where(rule.where);
    require(where.has_value());
    require(!where->height_m || (*where->height_m >= 0 && *where->height_m <= 2.5));
  }
  return true;
}

}  // namespace unietp::fuzz
