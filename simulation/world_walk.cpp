#include "simulation/world_state.h"

namespace unietp {

const NavigationGrid& WorldState::grid() const {
  if (!grid_) {
    grid_.emplace(scene_, *profile);
  } else {
    for (const std::size_t i : moved_) {
      const bool there = i < count() && physics_.has(static_cast<BodyId>(i));
      grid_->update(i, there ? &node(i) : nullptr, there ? &collider(i).shape : nullptr);
    }
  }
  moved_.clear();
  return *grid_;
}

namespace {

NavigationGrid::Cell cell_of(const Agent& agent, const NavigationGrid& grid) {
  const auto cell = grid.cell_at(agent.position);
  return grid.free(cell) ? cell : grid.nearest_free(agent.position).value_or(cell);
}

}  // namespace

const std::vector<std::int32_t>& WorldState::walk() const {
  const NavigationGrid& now = grid();
  const auto from = cell_of(agent(), now);
  // Who can be walked to from a cell can be walked to from all its neighbours.
  const bool known =
      !walk_.to.empty() && walk_.grid_version == now.version() && now.free(from) && walk_.to[now.index(from)] >= 0;
  if (!known) walk_ = {now.distances(from), now.version(), from};
  return walk_.to;
}

const std::vector<std::int32_t>& WorldState::steps() const {
  const NavigationGrid& now = grid();
  const auto from = cell_of(agent(), now);
  if (steps_.to.empty() || steps_.grid_version != now.version() || steps_.from != from) {
    steps_ = {now.distances(from), now.version(), from};
  }
  return steps_.to;
}

}  // namespace unietp
