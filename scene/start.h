#pragma once

#include <string>
#include <string_view>

#include "core/result.h"
#include "scene/node_index.h"
#include "scene/trace.h"

namespace unietp {

/// What differs between a home and a scene that grew out of it, the nodes in order of id: equal starts have equal
/// changes, whatever order their nodes are in.
Delta changes_of(const Scene& home, const Scene& scene);

/// The start that the changes make of the home. Changed nodes keep their place, new ones are appended in order of id,
/// then each that is gone leaves its place to the last: the others stay where the home has them, so that whoever knows
/// the home finds what differs without a search, and has in common with it what stayed. The changes must fit the home.
/// `places`: of the home's nodes.
Scene start_in(Scene home, const NodeIndex& places, const Delta& changes);
Scene start_in(const Scene& home, const Delta& changes);

/// The same for changes that were read, under a name of its own. Errors: Schema, naming `where`, for changes that do
/// not fit: what is gone or no longer holds was never there, what is new holds already, a relation speaks of nothing.
Result<Scene> start_in(std::string_view where, const Scene& home, const Delta& changes, const std::string& id);

}  // namespace unietp
