#pragma once

#include <string_view>
#include <vector>

#include "akb/knowledge.h"

namespace unietp {

/// All that a category is called or stands for in texts. The views are into the knowledge.
std::vector<std::string_view> names_of(const Category& category, const Knowledge& knowledge);

/// Whether a name may mean what another names: "table" may mean a coffee table.
bool may_mean(std::string_view name, std::string_view other);

}  // namespace unietp
