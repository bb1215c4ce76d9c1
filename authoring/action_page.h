#pragma once

#include <string>
#include <vector>

#include "simulation/profile.h"

namespace unietp {

/// The page docs/action-table.md: which simulator offers which action in which mode and profile, what each needs, and
/// the limits of the simulators' agents. `plain` and `wide` are the two profiles of the four simulators in their
/// order.
std::string action_page(const std::vector<Profile>& plain, const std::vector<Profile>& wide);

}  // namespace unietp
