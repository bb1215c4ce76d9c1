#pragma once

#include <optional>
#include <vector>

#include "generator/goal_variable.h"
#include "generator/scene_offer.h"
#include "generator/specification.h"

namespace unietp {

/// Starts drawn to see whether a refined goal may hold from the beginning.
inline constexpr int kStartsDrawn = 6;

/// `(count COMPARISON number (?variable - category) body)`
Formula counted(const GoalVariable& variable, Comparison comparison, int number, Formula body);

/// Makes the start have `number` objects of the variable's category that pass all tests, among them what the start
/// already demands of the category. False when it demands that there be no others.
bool demand_referents(Specification& refined, const GoalVariable& variable, const std::vector<Formula>& tests,
                      Comparison comparison, int number);

/// Two placeholders of one category, told apart by one attribute, state or place: "the red mug … and the blue mug". The
/// second gets the category of the first; nullopt when goal, start or knowledge base do not allow that.
std::optional<Specification> refine_each_its_own(const Specification& plain, const Knowledge& knowledge,
                                                 const SceneOffer& offer, Rng rng);

}  // namespace unietp
