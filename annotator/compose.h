#pragma once

#include "annotator/clause.h"
#include "core/result.h"

namespace unietp {

/// The goal of a message: resolves pronouns and repeated nouns, scopes the quantifiers, reads modifiers in the
/// start state. `New` phrases are existential in front of the whole text (of their alternative, inside an `or`).
/// Errors: Parse with the column of a phrase that could mean two things or nothing ("it" after two objects).
Result<Formula> compose(const Message& message);

}  // namespace unietp
