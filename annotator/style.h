#pragma once

#include <string>
#include <vector>

#include "annotator/noun_table.h"
#include "annotator/plan.h"
#include "generator/style.h"

namespace unietp {

/// Turns a plan so that it can be worded in a style that orders or joins what is said differently: InvertedOrder,
/// RelativeClause, ImplicitNeed, Condition. False when the plan has nothing that could be said that way;
/// another draw may.
bool turn_to_style(Plan& plan, Style style);

/// What a text of this style lacks of the style, in words; "" when it keeps the style's promise. `around`: categories
/// in the start scene, for what a text names beside the goal.
std::string style_fault(const std::string& text, Style style, const Formula& goal,
                        const std::vector<std::string>& around, const NounTable& lexicon);

}  // namespace unietp
