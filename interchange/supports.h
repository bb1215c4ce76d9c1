#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "interchange/draft.h"

namespace unietp {

/// Which node of a draft stands on or in which: as the file says, and where it says nothing of something that moves,
/// the smallest thing on or in which it could be.
class Supports {
 public:
  /// `boxes`: of each node, W.
  Supports(const Draft& draft, const std::vector<Bounds>& boxes);

  /// What holds a node, the smallest first.
  const std::vector<std::size_t>& of(std::size_t node) const { return holders_[node]; }
  /// The other way round.
  const std::vector<std::size_t>& children(std::size_t node) const { return children_[node]; }
  /// Everything that holds a node, directly or through others, sorted.
  const std::vector<std::size_t>& above(std::size_t node) const { return above_[node]; }
  /// Directly or through others.
  bool held_by(std::size_t node, std::size_t holder) const;
  /// By the volume of the boxes, ties by order.
  bool smaller(std::size_t a, std::size_t b) const;

 private:
  std::optional<std::size_t> holder_by_place(const Draft& draft, const std::vector<Bounds>& boxes,
                                             std::size_t node) const;
  std::vector<std::size_t> all_above(std::size_t node) const;

  std::vector<double> volumes_;
  std::vector<std::vector<std::size_t>> holders_, children_, above_;
};

}  // namespace unietp
