#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "simulation/solid.h"

namespace unietp {

/// The first solid on a ray.
struct SolidHit {
  double along = 0;             // in lengths of the ray's direction
  std::size_t solid = 0;        // position in the list that was built
  Vec3 normal = Vec3::UnitZ();  // outwards, unit, W
};

/// Ray casting. Embree finds candidate solids by boxes with a margin for its single precision; the hits are computed
/// here in double precision, so equal solids and rays give equal bits on every processor and for any number of threads.
/// A copy starts without solids. Not thread-safe; one per thread.
class Rays {
 public:
  Rays();
  Rays(const Rays&);
  Rays(Rays&&) noexcept;
  Rays& operator=(const Rays&);
  Rays& operator=(Rays&&) noexcept;
  ~Rays();

  /// Replaces the solids. Takes a few microseconds per ten solids.
  void build(std::vector<Solid> solids);
  const std::vector<Solid>& solids() const;
  /// The nearest solid from outside at most `farthest` lengths of `direction` away, of equally near ones the first in
  /// the list. Solids around `from` are ignored.
  std::optional<SolidHit> first(const Vec3& from, const Vec3& direction, double farthest) const;
  /// The next solid on the same ray after that one, where it is looked through: each solid comes once, where the ray
  /// first enters it.
  std::optional<SolidHit> next(const Vec3& from, const Vec3& direction, double farthest, const SolidHit& after) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace unietp
