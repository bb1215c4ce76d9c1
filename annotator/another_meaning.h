#pragma once

#include <string>

#include "akb/knowledge.h"
#include "annotator/noun_table.h"
#include "logic/formula.h"
#include "scene/scene.h"

namespace unietp {

/// Whether a listener in the home may take what a text names for another thing there, though the text can be read in
/// one way only: "the side table" for the nightstand, "something to fry them in" for the pot, "the dining table" of a
/// table in the office for no table at all, "the bedroom side table" for the one beside its door.
bool may_mean_another(const std::string& text, const Formula& goal, const Scene& home, const Knowledge& knowledge,
                      const NounTable& nouns);

}  // namespace unietp
