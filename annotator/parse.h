#pragma once

#include <string_view>
#include <vector>

#include "annotator/noun_table.h"
#include "annotator/text_reading.h"
#include "core/result.h"
#include "logic/formula.h"

namespace unietp {

/// All readings that the words allow, without two of one meaning, the likeliest first; see home_reading.h for those
/// that can be true in a home. Errors: Parse with the column of the first word that does not fit in the first reading,
/// when none is left; so is a text of more than kMostReadings combinations.
Result<std::vector<Reading>> readings_of(std::string_view text, const NounTable& lexicon);
inline constexpr int kMostReadings = 64;
/// What is wrong with a text of which only strained readings are left.
inline constexpr const char* kStrainedPronoun =
    "'it' would not mean what was named last; name again what is meant instead of it";

/// The goal of a text that has one reading. Errors: those above; Parse when there are several or the only one is
/// strained.
Result<Formula> parse_with(std::string_view text, const NounTable& lexicon);

}  // namespace unietp
