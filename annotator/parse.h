#pragma once

#include <string_view>

#include "annotator/noun_table.h"
#include "core/result.h"
#include "logic/formula.h"

namespace unietp {

/// parse_instruction with a lexicon that is already built, on a text without its context sentence.
Result<Formula> parse_with(std::string_view text, const NounTable& lexicon);

}  // namespace unietp
