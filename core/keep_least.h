#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace unietp {

/// Keeps the `most` things with the smallest measure, sorted by measure and, among equals, in their order. Does nothing
/// to a list that is not longer. Each thing is measured once.
template <class Thing, class Measure>
void keep_least(std::vector<Thing>& things, std::size_t most, const Measure& measure) {
  if (things.size() <= most) return;
  std::vector<std::pair<decltype(measure(things.front())), std::size_t>> order;
  for (std::size_t i = 0; i < things.size(); ++i) order.emplace_back(measure(things[i]), i);
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(most), order.end());
  std::vector<Thing> kept;
  for (std::size_t i = 0; i < most; ++i) kept.push_back(std::move(things[order[i].second]));
  things = std::move(kept);
}

}  // namespace unietp
