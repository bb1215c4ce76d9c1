#pragma once

#include "akb/rows.h"
#include "generator/style.h"

namespace unietp {

/// What a style of phrases calls things by (names_by_phrase): an alias of this kind.
AliasKind phrases_of(Style style);

}  // namespace unietp
