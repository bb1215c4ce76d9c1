#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace unietp {

/// Gives things one at a time in order of a measure that is costly to compute; ties in the order in which they were
/// added. Each is measured at most once, and only when it may be the next.
template <class Thing, class Rank>
class LeastFirst {
 public:
  /// nullopt leaves the thing out.
  using Measure = std::function<std::optional<Rank>(const Thing&)>;
  LeastFirst(std::size_t most, Measure measure) : left_(most), measure_(std::move(measure)) {}

  /// `bound` must not be greater than the measure.
  void add(Thing thing, Rank bound) {
    things_.push_back(std::move(thing));
    push({std::move(bound), false, things_.size() - 1});
  }

  /// nullopt when there are no more.
  std::optional<Thing> next() {
    if (!ordered_) std::make_heap(open_.begin(), open_.end(), std::greater<>());
    ordered_ = true;
    while (left_ > 0 && !open_.empty()) {
      std::pop_heap(open_.begin(), open_.end(), std::greater<>());
      const auto [rank, is_measured, place] = std::move(open_.back());
      open_.pop_back();
      if (is_measured) {
        --left_;
        return things_[place];
      }
      if (auto measured = measure_(things_[place])) push({std::move(*measured), true, place});
    }
    return std::nullopt;
  }

 private:
  using Open = std::tuple<Rank, bool, std::size_t>;  // of equals those not measured yet come first
  void push(Open open) {
    open_.push_back(std::move(open));
    if (ordered_) std::push_heap(open_.begin(), open_.end(), std::greater<>());
  }

  std::size_t left_;
  Measure measure_;
  std::vector<Thing> things_;
  std::vector<Open> open_;  // a heap once one was asked for: most need no order
  bool ordered_ = false;
};

}  // namespace unietp
