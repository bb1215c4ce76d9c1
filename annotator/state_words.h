#pragma once

#include <string>

#include "logic/vocabulary.h"

namespace unietp {

/// The word for a state of one object, after "is"; "" for what is no such state.
std::string state_word(Predicate predicate);
/// The preposition of a relation, after "is"; "" for what is no relation.
std::string before_object(Predicate predicate);

}  // namespace unietp
