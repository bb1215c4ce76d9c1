#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "annotator/naming.h"
#include "annotator/noun_table.h"
#include "core/rng.h"
#include "generator/specification.h"

namespace unietp {

/// A phrasing of the task's template with the things of the goal in its slots, named as the wording asks: "Place
/// {A:indefinite} {B:on}." gives "Place the mug on the sofa.", "Place a piece of tableware on the sofa.", "There are
/// two mugs here. Place the red one on the sofa." The slots name the placeholders; `goal` is the specification's, whose
/// variable of a placeholder has its name in lower case. What comes out need not say the goal: the caller reads it
/// back. Deterministic in rng. nullopt: a slot is of nothing that the goal speaks of, or its form does not fit what
/// the goal says of it.
std::optional<std::string> authored_text(std::string_view phrasing, const Specification& specification,
                                         const NounTable& lexicon, const Wording& wording, const HomeCounts& home,
                                         Rng rng);

}  // namespace unietp
