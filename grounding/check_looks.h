#pragma once

#include <optional>

#include "generator/specification.h"
#include "grounding/failure.h"
#include "logic/trace.h"
#include "scene/node_index.h"
#include "scene/scene.h"

namespace unietp {

/// Whether the colors, materials and states by which a goal tells things of one category apart can be seen: each thing
/// that is meant, beside itself with what another one has instead, has to make another picture (simulation/contrast.h).
/// The first pair that looks alike, or nullopt.
std::optional<GroundingFailure> check_looks(const Specification& specification, const Scene& start,
                                            const NodeIndex& places, const Trace& trace);

}  // namespace unietp
