#pragma once

#include <cstddef>
#include <vector>

#include "scene/scene.h"

namespace unietp {

/// The order in which a scene is told of, in lists for agents and in files: places in Scene::rooms and Scene::nodes.
/// Rooms first, then things room by room (what is in none last), and the things of a room, in an order drawn from the
/// names of the scene and of the things. So it tells nothing but rooms: not what was placed first, nor what was added
/// for a task. Equal scenes have equal orders, and a thing more or less leaves the others in theirs.
struct TellingOrder {
  std::vector<std::size_t> rooms, nodes;
};
TellingOrder telling_order(const Scene& scene);
/// The same scene with its rooms and nodes in that order.
Scene in_telling_order(const Scene& scene);

}  // namespace unietp
