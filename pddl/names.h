#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace unietp::pddl {

/// A text as a name of PDDL: lower case, a letter first, then letters, digits, '-' and '_'; never a word that PDDL
/// itself or our domains use.
std::string name_for(std::string_view text);

/// Names for texts, all different also when case is ignored; equal texts get different names. In the given order.
std::vector<std::string> names_for(const std::vector<std::string>& texts);

}  // namespace unietp::pddl
