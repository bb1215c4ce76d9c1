#pragma once

#include <string>
#include <vector>

#include "annotator/noun_table.h"
#include "generator/specification.h"

namespace unietp {

/// Checks of a text from any writer that need neither the reader nor a language model. Each returns the faults, worded
/// for a writer; empty when there are none.

/// No ids of a scene, coordinates, names of templates or markup; plain English letters; neither too short nor too long.
std::vector<std::string> form_faults(const std::string& text, const Specification& specification);

/// Every category, symbol, number, state, relation, quantifier and order of the goal has a word in the text, and the
/// text has no word for a category, color, number, state, quantifier or order that the goal does not have, no denial
/// where nothing is denied, and no other word that neither the goal nor the style explains (plain_words.h). Where a
/// name of the goal is missing, a word that differs by one letter is reported as a misspelling. It ignores syntax, so
/// it cannot tell what is put on what; reading back checks that. Words that say the opposite of the goal are faults,
/// too (opposite_check.h).
std::vector<std::string> saying_faults(const std::string& text, const Specification& specification,
                                       const NounTable& nouns);

}  // namespace unietp
