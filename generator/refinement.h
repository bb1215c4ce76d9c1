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

/// One object of the goal is named by a phrase that means it and others ("something to drink from", "a piece of
/// cutlery", "what I need for that"), or asked for by a sentence ("It's too dark to read."): the goal accepts all that
/// could satisfy it, and the start must leave none of them where it would already do.
std::optional<Specification> refine_by_phrase(const Specification& plain, const Knowledge& knowledge,
                                              const SceneOffer& offer, Style style, Rng rng);

/// One object of the goal is told from others of its category, in the way that the style needs: the red one, the one
/// that is not in the sink, all but the red one, the kitchen cabinet.
std::optional<Specification> refine_by_reference(const Specification& plain, const Knowledge& knowledge,
                                                 const SceneOffer& offer, Style style, Rng rng);

}  // namespace unietp
