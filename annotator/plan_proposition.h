#pragma once

#include "annotator/clause.h"
#include "annotator/phrase_plan.h"

namespace unietp {

/// The formula operator by operator. Its free variables are in the scope of `phrases`; what it binds is described there
/// where that can be done ("some mug that is dirty"), else by a proposition of the start.
Proposition proposition_of(const Formula& formula, PhrasePlanner& phrases);

/// An `expanded` formula in a form that reads well: one at-end in front of what it was pushed into, `imply` for an `or`
/// with a negative alternative, `exists` instead of double negation. Equal on every trace.
Formula gathered(const Formula& formula);

}  // namespace unietp
