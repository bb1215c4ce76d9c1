#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "grounding/layout.h"
#include "tests/support/committed_knowledge.h"

namespace unietp {

/// What the tests of this room share for one simulator: the committed knowledge, recipe and profile.
struct Surroundings {
  Knowledge knowledge;
  LayoutRecipe recipe;
  Profile profile;
};

inline std::optional<Surroundings> style_of(Simulator simulator) {
  const std::filesystem::path root = UNIETP_SOURCE_DIR;
  Knowledge knowledge = committed_knowledge(simulator);
  auto profile = load_profile(root / "data/simulators", simulator);
  if (!profile) {
    ADD_FAILURE() << format(profile.error());
    return std::nullopt;
  }
  auto recipe = load_recipe(root / "data/layouts", knowledge);
  if (!recipe) {
    ADD_FAILURE() << format(recipe.error());
    return std::nullopt;
  }
  return Surroundings{std::move(knowledge), std::move(*recipe), *profile};
}

/// A home as those of the benchmark are.
inline Result<Scene> full_home_of(const Surroundings& style, std::uint64_t seed) {
  LayoutOptions options;
  options.rooms = 7;
  options.objects = 210;
  return generate_layout(style.recipe, style.knowledge, style.profile, options, "home", Rng(seed));
}

inline Result<Scene> home_of(const Surroundings& style, std::uint64_t seed, int rooms = 5, int movable = 60) {
  LayoutOptions options;
  options.rooms = rooms;
  options.movable_objects = movable;
  return generate_layout(style.recipe, style.knowledge, style.profile, options, "home", Rng(seed));
}

}  // namespace unietp
