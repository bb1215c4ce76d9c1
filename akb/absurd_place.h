#pragma once

#include <functional>

#include "akb/rows.h"

namespace unietp {

/// Whether nobody would ever expect an object of one category on, in, next to or under one of another, however well it
/// fits there: `is_absurd` of sense/usual_places.h. An empty function refuses nothing.
using AbsurdPlace = std::function<bool(const Category& object, Predicate relation, const Category& receptacle)>;

}  // namespace unietp
