#pragma once

#include <set>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "expert/search_needs.h"
#include "simulation/profile.h"

namespace unietp {

/// The profile without the actions that a mode does not offer.
Profile profile_in(Mode mode, Profile profile);

/// The categories that can bring a state about, where no thing is in that state by hand alone: any of them will do.
std::vector<std::string> tools_for(const WantedState& wanted, const std::string& category, const Knowledge& knowledge,
                                   const Profile& profile);
/// The categories that a goal names, and those of the tools for the states that it needs.
std::set<std::string> categories_of_use(const Formula& goal, const SearchNeeds& needs, const Knowledge& knowledge,
                                        const Profile& profile);

}  // namespace unietp
