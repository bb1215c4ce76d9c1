#pragma once

#include <string>
#include <vector>

#include "annotator/noun_table.h"
#include "generator/style.h"
#include "logic/formula.h"

namespace unietp {

/// The phenomena of language that a text shows, in the order of Style: the one of its style, and of the others those
/// that can be told from its words. "Put the red pepper that is not in the fridge on the place where we eat dinner."
/// shows a description and a negation. `lexicon`: as the text is read, with the phrases of the goal
/// (function_phrases.h). `style_fault` of the text must be "".
std::vector<Style> phenomena_of(const std::string& text, Style style, const Formula& goal, const NounTable& lexicon);

/// The same by their names.
std::vector<std::string> names_of(const std::vector<Style>& styles);

}  // namespace unietp
