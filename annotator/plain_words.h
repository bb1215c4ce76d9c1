#pragma once

#include <string_view>

namespace unietp {

/// Whether a word adds nothing to what an instruction asks for: articles, pronouns, prepositions of manner, words of
/// courtesy, and verbs such as `put`, `take`, `go` and `make sure`, whose sense the goal's own words give. A closed
/// list, so that any other word has to be explained by the goal. Source: curated.
bool is_plain_word(std::string_view word);

/// Whether a word denies: "not", "never", "without".
bool is_denial(std::string_view word);

}  // namespace unietp
