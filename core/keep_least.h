#pragma once

#include <algorithm>
#include <cstddef>
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

}  // namespace unietp
