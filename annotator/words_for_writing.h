#pragma once

#include <string>
#include <vector>

#include "annotator/clause.h"

// The words that instructions are written with, a row for each predicate. Those that they are read with are a table of
// their own (words_for_reading.h), so that a wrong word here is found when the text is read back.
namespace unietp {

/// The word for a state of one object, after "is"; "" for what is no such state.
std::string state_word(Predicate predicate);
/// The preposition of a relation, after "is"; "" for what is no relation.
std::string before_object(Predicate predicate);
/// A color, material or substance in words: "black pepper", "Parmesan".
std::string symbol_words(const std::string& symbol);
/// Whether a substance is too thin to be spread.
bool is_drizzled(const std::string& substance);
/// "its floor" for "it", "the bedroom floor" for "the bedroom"; a room that is described keeps its place at the end.
std::string floor_of(const std::string& room, bool described);

/// Ways to ask for a state or relation: {s} the subject, {o} the object, {m} the symbol; the plainest first. Empty
/// where only "make sure that ..." says it.
std::vector<std::string> verbs(const Complement& said);
/// The same as people mostly ask for it, the most usual first.
std::vector<std::string> everyday_verbs(const Complement& said);

}  // namespace unietp
