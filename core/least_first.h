#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace unietp {

/// At most so many things with the least of a measure that is dear, one at a time, in its order and else in that in
/// which they were added. Measured, once, is only what may come before the next one.
template <class Thing, class Rank>
class LeastFirst {
 public:
  /// nullopt: the thing is none of those.
  using Measure = std::function<std::optional<Rank>(const Thing&)>;
  LeastFirst(std::size_t most, Measure measure) : left_(most), measure_(std::move(measure)) {}

  /// `bound` is never more than the measure.
  void add(Thing thing, Rank bound) {
    things_.push_back(std::move(thing));
    open_.push({std::move(bound), false, things_.size() - 1});
  }

  /// nullopt when there are no more.
  std::optional<Thing> next() {
    while (left_ > 0 && !open_.empty()) {
      const auto [rank, is_measured, place] = open_.top();
      open_.pop();
      if (is_measured) {
        --left_;
        return things_[place];
      }
      if (auto measured = measure_(things_[place])) open_.push({std::move(*measured), true, place});
    }
    return std::nullopt;
  }

 private:
  using Open = std::tuple<Rank, bool, std::size_t>;  // of equals those not measured yet come first
  std::size_t left_;
  Measure measure_;
  std::vector<Thing> things_;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open_;
};

}  // namespace unietp
