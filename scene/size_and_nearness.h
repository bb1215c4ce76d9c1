#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/shared_list.h"
#include "scene/scene.h"

namespace unietp {

// Which things are clearly the largest, the smallest or the nearest of their category.

/// A thing is `large` when its box has at least this many times the volume of every other of its category, `small` when
/// every other has that many times its volume.
inline constexpr double kClearlyLarger = 1.3;
/// x is `nearest` to y when every other of x's category is further from y by this length and by this share of x's own
/// distance, center to center.
inline constexpr double kClearlyNearer_m = 0.25, kClearlyNearer = 0.2;
/// Whether a distance is shorter than another by both margins. Meters.
bool clearly_nearer(double distance_m, double other_m);

/// x is `nearest` to y, by places in the list of nodes.
struct NearestPair {
  std::size_t winner = 0, other = 0;
};
/// Among the nodes at these places (which hold all of a category or none); by winner, then by what it is nearest to.
std::vector<NearestPair> nearest_pairs(const SharedList<Node>& nodes, const std::vector<std::size_t>& places);
/// Those that have a size among their category, with "large" or "small".
std::vector<std::pair<std::size_t, std::string>> sizes_of(const SharedList<Node>& nodes,
                                                          const std::vector<std::size_t>& places);

}  // namespace unietp
