#pragma once

#include "annotator/clause.h"
#include "annotator/text_reading.h"
#include "annotator/word_choices.h"
#include "core/result.h"

namespace unietp {

/// The goal of a message, and the facts that it states: resolves pronouns and repeated nouns, scopes the quantifiers,
/// reads modifiers in the start state. `New` phrases are existential in front of the whole text (of their alternative,
/// inside an `or`). `choices`: which of two objects "it" is, and the like. Errors: Parse with the column of a phrase
/// that could mean two things or nothing.
Result<Reading> compose(const Message& message, WordChoices& choices);

}  // namespace unietp
