#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "akb/knowledge.h"

namespace unietp {

/// Whether two colors, or two materials, are told apart at a glance: equal ones are not, nor are neighbors such as
/// gold and yellow, paper and cardboard. Source: curated; colors next to each other among Berlin and Kay's basic
/// color terms, materials that surfaces do not tell.
bool distinguishable(std::string_view one, std::string_view other);

/// Whether one thing of the category may be so much larger than another that it is clearly so (kClearlyLarger of
/// scene/size_and_nearness.h): by its usable models, or, where it has none, by scaling its typical box within what
/// `usable` allows.
bool comes_in_sizes(const Category& category, const Knowledge& knowledge);

}  // namespace unietp
