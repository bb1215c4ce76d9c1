#pragma once

#include "annotator/clause.h"
#include "annotator/references.h"

namespace unietp {

/// The formula that a proposition says. What it binds can be referred to within it alone; anything else that it speaks
/// of was named before, or is the error of `references`.
Formula compose_proposition(const Proposition& said, References& references);

}  // namespace unietp
