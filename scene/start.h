#pragma once

#include <string>
#include <string_view>

#include "core/result.h"
#include "scene/node_index.h"
#include "scene/trace.h"

namespace unietp {

/// The difference between a home and a scene made from it, with nodes in order of id, so that equal starts have equal
/// changes whatever order their nodes are in.
Delta changes_of(const Scene& home, const Scene& scene);

/// The home with the changes applied. Nodes that change keep their place, new ones are appended in order of id, and the
/// last node takes the place of each one that is removed; all others keep the place and the memory that they have in
/// the home, so that differences are found without a search. The changes must fit the home. `places` is the index of
/// the home's nodes.
Scene start_in(Scene home, const NodeIndex& places, const Delta& changes);
Scene start_in(const Scene& home, const Delta& changes);

/// The same for changes from a file; the start gets the given id. Errors: Schema, naming `where`, for changes that do
/// not fit: a removed node or relation that does not exist, an added one that exists already, a relation of unknown
/// ids.
Result<Scene> start_in(std::string_view where, const Scene& home, const Delta& changes, const std::string& id);

}  // namespace unietp
