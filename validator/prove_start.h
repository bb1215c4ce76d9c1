#pragma once

#include <vector>

#include "core/error.h"
#include "scene/scene.h"

namespace unietp {

/// What is wrong with a start scene by physics alone: relations that are recorded but not there or there but not
/// recorded, and bodies that move more than `rest_m` metres when physics runs on.
std::vector<Error> prove_start(const Scene& start, double rest_m, const std::string& file);

}  // namespace unietp
