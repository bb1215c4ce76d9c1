#pragma once

#include <string>

namespace unietp {

/// The page in which a person plays a session of the server that it comes from: the one whose token follows `#` in its
/// address, or one of its own. It asks nobody else for anything, and shows texts as texts whatever they contain.
std::string play_page();

}  // namespace unietp
