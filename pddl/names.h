#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace unietp::pddl {

/// Turns a text into a PDDL name: lower case, a letter first, then letters, digits, '-' and '_'; never a keyword of
/// PDDL or a type of our domains.
std::string name_for(std::string_view text);

/// Names for texts, in the given order. All differ, also for equal texts and when case is ignored.
std::vector<std::string> names_for(const std::vector<std::string>& texts);

}  // namespace unietp::pddl
