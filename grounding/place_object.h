#pragma once

#include <optional>
#include <span>
#include <string>

#include "core/rng.h"
#include "grounding/workspace.h"

namespace unietp {

/// How a place is searched for.
struct PlacementOptions {
  int draws = 40;                               // poses tried
  bool keep_sweeps_clear = true;                // not in the way of a door or drawer
  bool aligned = false;                         // same front as the receptacle
  std::optional<Bounds> within = std::nullopt;  // the box's bounds must meet this region of W
  bool settle = true;                           // false: not let down in physics, a hair over the surface
};

/// What a search for a place gave: a pose at rest, or what the last draw failed on, for people.
struct FoundPlace {
  std::optional<Pose> pose;
  std::string obstacle;  // "hits wall", "does not fit", "rolls away", …
};

/// A pose at rest for `node` on or inside a receptacle of the workspace: on one of its surfaces in a row with what is
/// there of its category, else drawn, inside along the receptacle's sides; free by FCL with a gap, let down in physics
/// until it rests (what stands flat on something level that never moves is at rest where it is put, and is not), and
/// kept only if it moved little, stands in the relation asked and in no `on` or `inside` that the knowledge lacks;
/// without settling, drawn and free only. `index` is the node's own when it is in the workspace already, else one past
/// the last. The workspace is unchanged afterwards. Deterministic in rng.
FoundPlace find_place(Workspace& workspace, const Node& node, std::size_t index, Predicate relation,
                      std::size_t receptacle, const PlacementOptions& options, Rng rng);

/// The same on the floor of a room, or of a part of it.
FoundPlace find_place_on_floor(Workspace& workspace, const Node& node, std::size_t index, const Bounds& area,
                               const PlacementOptions& options, Rng rng);

}  // namespace unietp
