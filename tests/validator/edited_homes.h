#pragma once

#include <utility>
#include <vector>

#include "core/rng.h"
#include "scene/scene.h"

namespace unietp::testing {

/// A home of five rooms in a row with 50 objects at drawn places. Homes of different numbers have only the kinds of
/// their rooms and objects in common.
Scene drawn_home(std::uint64_t number);

/// A change that leaves a home recognizable.
struct HomeEdit {
  const char* name;
  Scene (*made)(Scene home, Rng rng);
};
extern const std::vector<HomeEdit> kHomeEdits;

/// `edit` gets the list of the home's nodes.
void edit_nodes(Scene& home, auto edit) {
  std::vector<Node> nodes(home.nodes.begin(), home.nodes.end());
  edit(nodes);
  home.nodes = {};
  for (Node& node : nodes) home.nodes.push_back(std::move(node));
}

/// Single ones of these, by themselves.
Scene mirrored(Scene home, Rng rng);
Scene renumbered(Scene home, Rng rng);
/// Every object moved by up to so many meters along each wall.
Scene shaken(Scene home, Rng rng, double most_m);
/// Only some rooms with what is in them, the first ones.
Scene with_rooms(Scene home, std::size_t count);
/// The same, and beside them the other rooms of another home.
Scene with_rooms_of(const Scene& home, std::size_t count, const Scene& other);

}  // namespace unietp::testing
