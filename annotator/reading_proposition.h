#pragma once

#include "annotator/clause.h"
#include "annotator/reading.h"

namespace unietp {

/// Reads a proposition at the cursor: each operator stands in front of what it is about. The first word that does not
/// fit is the error of `words`; so is nesting deeper than formulas may nest.
Proposition read_proposition(PhraseReader& words);

}  // namespace unietp
