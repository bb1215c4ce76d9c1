#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "simulation/solid.h"

namespace unietp {

struct SolidHit {
  double along = 0;             // in lengths of the ray's direction
  std::size_t solid = 0;        // position in the list that was built
  Vec3 normal = Vec3::UnitZ();  // outwards, unit, W
};

/// What a ray meets first. Embree finds the solids near the ray, in boxes grown by more than its single precision can
/// err; where they are met is computed here in double precision. So equal solids and rays give equal bits, whatever
/// the processor and the number of threads. A copy starts without solids. Not thread-safe; one a thread.
class Rays {
 public:
  Rays();
  Rays(const Rays&);
  Rays(Rays&&) noexcept;
  Rays& operator=(const Rays&);
  Rays& operator=(Rays&&) noexcept;
  ~Rays();

  /// Takes the place of the solids before. A few microseconds for each ten solids.
  void build(std::vector<Solid> solids);
  const std::vector<Solid>& solids() const;
  /// The nearest solid from outside at most `farthest` lengths of `direction` away, of equally near ones the first in
  /// the list. One around `from` is looked through.
  std::optional<SolidHit> first(const Vec3& from, const Vec3& direction, double farthest) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace unietp
