#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "core/result.h"
#include "core/rng.h"
#include "scene/scene.h"
#include "simulation/profile.h"

namespace unietp {

/// What a home of one simulator's style is made of; data/layouts/<simulator>.csv.
struct FurnitureRule {
  std::string room;  // room type
  std::string category;
  int at_least = 0, at_most = 1;
  std::string where;  // wall, centre, corner, on:<category> (stands on that furniture), wall-hung
};
struct LayoutRecipe {
  std::vector<FurnitureRule> furniture;
  std::vector<std::string> rooms;  // room types of a home, the obligatory ones first
};
/// Errors: Schema with file, line, column.
Result<LayoutRecipe> load_recipe(const std::filesystem::path& folder, const Knowledge& knowledge);

struct LayoutOptions {
  int rooms = 6;             // >= 4
  int movable_objects = 60;  // asked for; fewer when they find no place
  int objects = 0;           // when above 0: furniture and movable objects together, instead of movable_objects
  int attempts_per_object = 40;
};

/// A furnished home at rest: rooms as a partition of a rectangle, joined by openings so that the body reaches every
/// room; furniture against walls with its doors free to open; small objects where the knowledge base puts them, each
/// placed without touching (FCL), dropped and settled (Bullet) and kept only if it lies where it was meant to. Object
/// states are drawn (mostly defaults). The agent stands in the first room. Deterministic in rng. Errors: Unsatisfiable
/// when the obligatory furniture finds no place in any attempt; says what.
Result<Scene> generate_layout(const LayoutRecipe& recipe, const Knowledge& knowledge, const Profile& profile,
                              const LayoutOptions& options, std::string id, Rng rng);

}  // namespace unietp
