#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/rng.h"
#include "grounding/furniture_position.h"
#include "grounding/workspace.h"

namespace unietp {

/// How furniture is placed.
struct FurnishOptions {
  int draws = 250;                // poses tried for one piece
  double clearance_m = 0.7;       // kept free in front of what stands at a wall
  double clearance_open_m = 0.9;  // of what opens
};

/// Space that has to stay free: before openings, in front of furniture, where doors swing, above a coffee machine.
struct KeepOut {
  Bounds space;
  std::optional<std::size_t> owner;  // node it belongs to
};

/// Space before the openings of a scene.
std::vector<KeepOut> keep_outs_at_openings(const Scene& scene);
/// Space inside the entrance of a generated home.
KeepOut keep_out_at_entrance(const Scene& scene);
/// All keep-outs of a furnished scene that what stands in a room may come into: openings, fronts, sweeps and what
/// lies above devices that things are put on.
std::vector<KeepOut> keep_outs_of(const Workspace& workspace, const FurnishOptions& options, std::size_t room);

/// Sets a piece down in a room (index) as `where` says; its pose is overwritten. Back to the wall, front free, doors
/// free to open, no keep-out touched; free by FCL. Adds its own keep-outs. False when no draw fits.
bool place_furniture(Workspace& workspace, std::vector<KeepOut>& keep_outs, std::size_t room, Node node,
                     const FurniturePosition& where, const FurnishOptions& options, Rng rng);

}  // namespace unietp
