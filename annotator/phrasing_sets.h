#pragma once

#include <string_view>

#include "annotator/noun_table.h"

namespace unietp {

/// Sets of wordings. Everyday: short imperatives, as people ask for things. All: a wide choice of frames and statements
/// besides, which is divided into Training and Benchmark: these two are disjoint, nouns aside.
enum class Phrasings { Everyday, All, Training, Benchmark };

/// The set of a text's wording, Training or Benchmark, by a hash of the text without its nouns, articles and numbers.
/// The sets are disjoint by construction, and each has about half of the wordings of every goal.
Phrasings phrasings_of(std::string_view text, const NounTable& nouns);

}  // namespace unietp
