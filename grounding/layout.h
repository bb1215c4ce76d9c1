#pragma once

#include <string>

#include "akb/knowledge.h"
#include "core/result.h"
#include "core/rng.h"
#include "grounding/recipe.h"
#include "scene/scene.h"
#include "simulation/profile.h"

namespace unietp {

/// How large a home is and how much is in it.
struct LayoutOptions {
  int rooms = 6;                 // >= 4
  int movable_objects = 60;      // asked for; fewer when they find no place
  int objects = 0;               // when above 0: furniture and movable objects together, instead of movable_objects
  int attempts_per_object = 40;  // poses tried for one
  bool settle = true;            // let each object fall until it rests; without, it lies a hair over its place
};

/// A furnished home at rest: rooms as the recipe's weights and areas say, joined by openings so that the body reaches
/// every room; furniture in the numbers that the recipe gives, each piece in reach, its front and the way of its doors
/// and drawers free, windows in outer walls; small objects as the recipe and the knowledge put them, each placed
/// without touching (FCL), dropped and settled (Bullet) and kept only if it lies where it was meant to. Object states
/// are drawn (mostly defaults). The agent stands in the first room. Deterministic in rng. Errors: Unsatisfiable when
/// the obligatory furniture finds no place in any attempt; says what.
Result<Scene> generate_layout(const LayoutRecipe& recipe, const Knowledge& knowledge, const Profile& profile,
                              const LayoutOptions& options, std::string id, Rng rng);

}  // namespace unietp
