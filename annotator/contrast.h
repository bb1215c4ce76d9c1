#pragma once

#include <string>

#include "annotator/noun_table.h"
#include "core/rng.h"
#include "logic/formula.h"
#include "scene/scene.h"

namespace unietp {

/// ", not the blue one": what follows a command about the one red mug of a goal in a home that also has a blue one. ""
/// when no one word tells another such thing from the one that is meant, or the goal describes none or several by a
/// colour, a material or a state. `home`: at its start. Deterministic in rng.
std::string contrast_of(const Formula& goal, const Scene& home, const NounTable& lexicon, Rng& rng);

}  // namespace unietp
