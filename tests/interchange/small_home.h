#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "scene/scene.h"

namespace unietp::testing {

/// A home of an L-shaped room and a small one with an opening between them, furnished with things of the knowledge
/// base, drawn with their turns and sizes: in the air, none above another. The same seed gives the same home.
Scene small_home(const Knowledge& knowledge, std::uint64_t seed);

/// What differs between a home and what became of it on its way out and in again: rooms, openings, objects in order
/// (category, pose, size, states), agent. Lengths within `tolerance_m`, turns within as many radians. A sentence each.
std::vector<std::string> differences(const Scene& home, const Scene& again, double tolerance_m);

}  // namespace unietp::testing
