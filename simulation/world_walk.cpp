#include "simulation/world_state.h"

namespace unietp {

const NavigationGrid& WorldState::grid() const {
  if (!grid_) {
    grid_.emplace(scene_, *profile);
  } else {
    for (const std::size_t i : moved_) {
      const bool there = i < count() && physics_.has(BodyId::node(i));
      grid_->update(i, there ? &node(i) : nullptr, there ? &collider(i).shape : nullptr);
    }
  }
  moved_.clear();
  return *grid_;
}

NavigationGrid::Cell WorldState::cell() const {
  const auto here = grid().cell_at(agent().position);
  return grid().free(here) ? here : grid().nearest_free(agent().position).value_or(here);
}

const CellSet& WorldState::walk() const { return floods_.around(grid(), cell()).to; }

std::int32_t WorldState::steps_to(NavigationGrid::Cell low, NavigationGrid::Cell high, std::int32_t most) const {
  return floods_.steps(grid(), cell(), low, high, most);
}

std::optional<Vec2> WorldState::standing_place(std::size_t i) const {
  constexpr std::size_t kMostRemembered = 256;
  const Node& target = node(i);
  const Flood& walk = floods_.around(grid(), cell());
  Digester key;
  key.add(walk.number).add(collider(i).digest.a).add(collider(i).digest.b);
  for (const double part : target.size) key.add(part);
  for (const double part : target.pose.position) key.add(part);
  for (const double part : target.pose.rotation.coeffs()) key.add(part);
  key.add(std::uint64_t{target.movable} * 2 + std::uint64_t{target.openable});
  if (standing_.size() >= kMostRemembered) standing_.clear();
  return unietp::standing_place(scene_, physics_, i, {target, collider(i).shape, grid(), walk.to, *profile},
                                standing_[key.digest()]);
}

}  // namespace unietp
