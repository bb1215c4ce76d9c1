#pragma once

#include "akb/knowledge.h"
#include "akb/rows.h"
#include "generator/specification.h"
#include "generator/style.h"

namespace unietp {

class PlaceUses;

/// What a style of phrases calls things by (names_by_phrase): an alias of this kind.
AliasKind phrases_of(Style style);

/// Whether people name things of a goal by a phrase of the style (names_by_phrase), for what they want done with them:
/// who wants to read does not have something to read closed, and who wants cutlery put away means certain pieces.
/// `uses`: of the places; null: nothing is known. True for a style of other words.
bool may_use_phrases(Style style, const Specification& plain, const Knowledge& knowledge, const PlaceUses* uses);

}  // namespace unietp
