#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace unietp {

/// Of more than `most` things those with the least of a measure, in its order and else in theirs; fewer are left as
/// they are.
template <class Thing, class Measure>
void keep_least(std::vector<Thing>& things, std::size_t most, const Measure& measure) {
  if (things.size() <= most) return;
  std::stable_sort(things.begin(), things.end(),
                   [&](const Thing& a, const Thing& b) { return measure(a) < measure(b); });
  things.resize(most);
}

/// At most so many things with the least of a measure that is dear, in its order and else in theirs. `bound` is never
/// more than the measure, which is asked for only where it can matter.
template <class Thing, class Bound, class Measure>
std::vector<Thing> least_of(const std::vector<Thing>& things, std::size_t most, const Bound& bound,
                            const Measure& measure) {
  using Ranked = std::pair<decltype(measure(things.front())), std::size_t>;
  std::vector<Ranked> order, best;
  for (std::size_t i = 0; i < things.size(); ++i) order.emplace_back(bound(things[i]), i);
  std::sort(order.begin(), order.end());
  for (const auto& [least, i] : order) {
    if (best.size() == most && (most == 0 || best.back().first < least)) break;
    Ranked one(measure(things[i]), i);
    best.insert(std::upper_bound(best.begin(), best.end(), one), std::move(one));
    if (best.size() > most) best.pop_back();
  }
  std::vector<Thing> kept;
  for (const auto& [value, i] : best) kept.push_back(things[i]);
  return kept;
}

}  // namespace unietp
