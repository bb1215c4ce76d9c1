#pragma once

#include <string>

#include "scene/scene.h"

namespace unietp {

/// Which bound of core/limits.h on the size of a home the rooms, openings and walls of a scene exceed, with what is
/// accepted; "" for none. Drawing and walking a home take time and memory by its area.
std::string excess_of(const Scene& scene);

}  // namespace unietp
