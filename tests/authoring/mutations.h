#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/rng.h"

namespace unietp::testing_support {

/// The text with one to three changes: a byte overwritten, put in or dropped; a word or a bracketed part dropped,
/// doubled, or swapped with another; a word replaced by a near one or by any of `words`; a number changed.
std::string mutated(std::string text, const std::vector<std::string>& words, Rng& rng);

/// Every word of a text, sorted, without repeats.
std::vector<std::string> words_in(std::string_view text);

}  // namespace unietp::testing_support
