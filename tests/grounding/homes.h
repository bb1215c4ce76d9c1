#pragma once

#include <unistd.h>

#include <filesystem>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "akb/knowledge.h"
#include "grounding/layout.h"

namespace unietp {

/// What the tests of this room share for one simulator: the committed knowledge, recipe and profile.
struct Surroundings {
  Knowledge knowledge;
  LayoutRecipe recipe;
  Profile profile;
};

/// Compiled once a process from the committed tables into a file of the test's own.
inline std::filesystem::path compiled_knowledge() {
  static const std::filesystem::path path = [] {
    const std::filesystem::path root = UNIETP_SOURCE_DIR;
    auto file = std::filesystem::temp_directory_path() / ("unietp_grounding_" + std::to_string(::getpid()) + ".sqlite");
    for (const Error& error : compile_knowledge(root / "data/akb", file)) ADD_FAILURE() << format(error);
    return file;
  }();
  return path;
}

inline std::optional<Surroundings> style_of(Simulator simulator) {
  const std::filesystem::path root = UNIETP_SOURCE_DIR;
  auto knowledge = load_knowledge(compiled_knowledge(), simulator);
  auto profile = load_profile(root / "data/simulators", simulator);
  if (!knowledge || !profile) {
    ADD_FAILURE() << format(knowledge ? profile.error() : knowledge.error());
    return std::nullopt;
  }
  auto recipe = load_recipe(root / "data/layouts", *knowledge);
  if (!recipe) {
    ADD_FAILURE() << format(recipe.error());
    return std::nullopt;
  }
  return Surroundings{std::move(*knowledge), std::move(*recipe), *profile};
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
