#pragma once

#include <string>
#include <vector>

#include "annotator/noun_table.h"
#include "generator/specification.h"

namespace unietp {

/// Checks of a text by whoever wrote it that need neither the reader nor a language model. Each gives what is wrong, in
/// words that a writer can act on; empty when nothing is.

/// No ids of a scene, coordinates, names of templates or markup; plain English letters; neither too short nor too long.
std::vector<std::string> form_faults(const std::string& text, const Specification& specification);

/// Every category, symbol, number, state, relation, quantifier and order of the goal has a word in the text, and the
/// text has no word for a category, colour, number, state, quantifier or order that the goal does not have. Where a
/// name of the goal is missing, a word that is a letter off it is told as a slip of the pen. It sees no syntax, so it
/// cannot tell who is put on whom; that is what reading back is for.
std::vector<std::string> saying_faults(const std::string& text, const Specification& specification,
                                       const NounTable& nouns);

}  // namespace unietp
