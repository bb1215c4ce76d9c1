#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "generator/specification.h"
#include "grounding/layout.h"
#include "logic/formula.h"
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

inline Formula parsed(const std::string& text, FormulaUse use) {
  auto formula = parse_formula("test", text, use);
  EXPECT_TRUE(formula) << text << (formula ? "" : format(formula.error()));
  return formula ? *formula : Formula{};
}

/// A specification by hand, of a goal and the constraints of its start.
inline Specification specification(const std::string& goal, const std::vector<std::string>& init) {
  Specification result;
  result.template_name = "by-hand";
  result.goal = parsed(goal, FormulaUse::Goal);
  for (const std::string& one : init) result.init.push_back(parsed(one, FormulaUse::State));
  return result;
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
