#pragma once

#include <span>
#include <string_view>

#include "logic/vocabulary.h"

// The words that instructions are read with, a row for each predicate; nothing here is shared with the writer
// (words_for_writing.h), so that its mistakes are found.
namespace unietp {

/// Words that say a predicate.
struct PredicatePhrase {
  std::string_view words;
  std::string_view after;  // of verbs: what follows the object ("cut ... into slices")
  bool optional = false;   // `after` may be left out
  Predicate predicate = Predicate::Open;
};

// Of forms that begin alike, the longer comes first.
/// States of one object, after "is": "closed", "shut".
std::span<const PredicatePhrase> state_phrases();
/// Prepositions of relations: "next to".
std::span<const PredicatePhrase> preposition_phrases();
/// Words before a substance or an attribute: "filled with".
std::span<const PredicatePhrase> symbol_phrases();
/// Verbs that bring a state about: "switch on".
std::span<const PredicatePhrase> verb_phrases();
/// What is to be done to what is put somewhere: "heated" in "put a heated egg on a plate". `optional`: it may also say
/// how a thing is.
std::span<const PredicatePhrase> result_phrases();

/// Words that may say a state or relation, in any text: whoever says it uses one of these. Beginnings of words, with
/// blanks between: "open clos". "" for what needs no word of its own.
std::string_view words_for(Predicate predicate);

/// Beginnings of words that demand this state and nothing else; "" where each word has other uses as well.
std::string_view words_only_for(Predicate predicate);

/// Whether a word begins with one of a list's beginnings; a beginning that ends in '.' is the whole word.
bool is_among(std::string_view word, std::string_view list);

}  // namespace unietp
