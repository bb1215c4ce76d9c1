#pragma once

#include <string_view>

#include "annotator/noun_table.h"

namespace unietp {

/// Which ways to say a thing: those of training and those of the benchmark share no turn of phrase, whatever the nouns.
enum class Phrasings { All, Training, Benchmark };

/// The set that a text's turn of phrase is in, Training or Benchmark: a text without its nouns, articles and numbers
/// falls into the one or the other, always the same. So the sets are disjoint by construction, and each has about half
/// of the phrasings of every goal.
Phrasings phrasings_of(std::string_view text, const NounTable& nouns);

}  // namespace unietp
