#pragma once

#include <string>
#include <vector>

#include "annotator/noun_table.h"
#include "annotator/plan.h"
#include "generator/style.h"

namespace unietp {

/// Changes a plan for a style that orders or joins its parts differently: InvertedOrder, SubordinateClause,
/// ImplicitNeed, Condition. False when no part of the plan fits the style; that of another draw may.
bool turn_to_style(Plan& plan, Style style);

/// The feature of the style that a text lacks, in words; "" when it has all. `around`: categories in the start scene,
/// for objects that a text names in addition to the goal.
std::string style_fault(const std::string& text, Style style, const Formula& goal,
                        const std::vector<std::string>& around, const NounTable& lexicon);

}  // namespace unietp
