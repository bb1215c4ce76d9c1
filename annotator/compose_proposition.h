#pragma once

#include "annotator/clause.h"
#include "annotator/references.h"

namespace unietp {

/// The formula of a proposition. Its variables can be referred to only inside it; everything else must have been named
/// before, or is the error of `references`.
Formula compose_proposition(const Proposition& said, References& references);

}  // namespace unietp
