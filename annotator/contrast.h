#pragma once

#include <optional>
#include <string>

#include "annotator/noun_table.h"
#include "core/rng.h"
#include "logic/formula.h"
#include "scene/scene.h"

namespace unietp {

/// The text with "the red mug, not the blue one" in place of the first "the red mug" of a goal in a home that also has
/// a blue one. nullopt when no one word tells another such thing from the one that is meant, when the goal describes
/// none or several by a color, a material or a state, and when the text does not call it so. `home`: at its start.
/// Deterministic in rng.
std::optional<std::string> contrasted(const std::string& text, const Formula& goal, const Scene& home,
                                      const NounTable& lexicon, Rng& rng);

}  // namespace unietp
