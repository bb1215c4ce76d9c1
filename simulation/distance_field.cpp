#include "simulation/distance_field.h"

#include <algorithm>

namespace unietp {

using Cell = NavigationGrid::Cell;

DistanceField::DistanceField(const NavigationGrid& grid, Cell from)
    : from_(from),
      width_(grid.width()),
      height_(grid.height()),
      stretches_((static_cast<std::size_t>(width_) + kStretch - 1) / kStretch),
      open_(grid.free_cells()),
      places_(stretches_ * static_cast<std::size_t>(height_), 0) {
  if (!open_.has(from.x, from.y)) return;
  front_.push_back(from);
  open_.set(from.x, from.y, false);
  set(from, 0);
}

void DistanceField::set(Cell cell, std::int32_t steps) {
  std::uint32_t& place = places_[stretch(cell)];
  if (place == 0) {
    steps_.emplace_back().fill(kNoWay);
    place = static_cast<std::uint32_t>(steps_.size());
  }
  steps_[place - 1][static_cast<std::size_t>(cell.x) % kStretch] = static_cast<std::uint16_t>(steps);
}

void DistanceField::go_on() {
  ++far_;
  for (const Cell& cell : front_) {
    for (const Cell& there :
         {Cell{cell.x + 1, cell.y}, Cell{cell.x - 1, cell.y}, Cell{cell.x, cell.y + 1}, Cell{cell.x, cell.y - 1}}) {
      if (!open_.has(there.x, there.y)) continue;
      open_.set(there.x, there.y, false);
      set(there, far_);
      next_.push_back(there);
    }
  }
  front_.swap(next_);
  next_.clear();
}

void DistanceField::finish() {
  while (!ended()) go_on();
}

std::int32_t DistanceField::fewest_found(Cell low, Cell high, std::int32_t most) const {
  const int left = std::max(0, low.x), right = std::min(width_ - 1, high.x) + 1;
  std::uint16_t fewest = kNoWay;
  for (int y = std::max(0, low.y); y <= std::min(height_ - 1, high.y); ++y) {
    for (int x = left; x < right;) {
      const int first = x % static_cast<int>(kStretch), count = std::min(static_cast<int>(kStretch) - first, right - x);
      if (const std::uint32_t place = places_[stretch({x, y})]) {
        const std::uint16_t* steps = steps_[place - 1].data() + first;
        for (int i = 0; i < count; ++i) fewest = std::min(fewest, steps[i]);
      }
      x += count;
    }
  }
  return fewest == kNoWay || fewest > most ? -1 : fewest;
}

std::int32_t DistanceField::fewest_to(Cell low, Cell high, std::int32_t most) {
  std::int32_t fewest = fewest_found(low, high, most);
  const auto is_there = [&](const Cell& cell) {
    return cell.x >= low.x && cell.x <= high.x && cell.y >= low.y && cell.y <= high.y;
  };
  while (fewest < 0 && !ended() && far_ < most) {
    go_on();
    if (std::any_of(front_.begin(), front_.end(), is_there)) fewest = far_;
  }
  return fewest;
}

}  // namespace unietp
