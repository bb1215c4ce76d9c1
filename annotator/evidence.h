#pragma once

#include <string_view>

#include "logic/vocabulary.h"

namespace unietp {

/// Words that may say a state or relation, in any text: whoever says it uses one of these. Beginnings of words, with
/// blanks before and between: " open clos". "" for what needs no word of its own.
std::string_view words_for(Predicate predicate);

/// Beginnings of words that demand this state and nothing else; "" where each word has other uses as well.
std::string_view words_only_for(Predicate predicate);

/// Whether a word begins with one of a list's beginnings; a beginning that ends in '.' is the whole word.
bool is_among(std::string_view word, std::string_view list);

}  // namespace unietp
