#pragma once

#include <optional>
#include <string>

#include "akb/knowledge.h"
#include "annotator/noun_table.h"
#include "core/rng.h"
#include "generator/specification.h"
#include "scene/scene.h"

namespace unietp {

/// A text with one word changed, and what it asks for.
struct MinimalPair {
  std::string text;
  Formula goal;
};

/// A text that differs from one of a task in one word and asks for another goal, which is possible in the home and not
/// yet so. Neither text means the other's goal there. Drawn from opposite words, numbers, colors and other things of
/// the home, those of the same kind before all others; nullopt when none of the words that were tried gives such a
/// text. `specification`: of the task, with the style direct. Deterministic in rng.
std::optional<MinimalPair> minimal_pair(const std::string& text, const Specification& specification,
                                        const Knowledge& knowledge, const NounTable& nouns, const Scene& home, Rng rng);

}  // namespace unietp
