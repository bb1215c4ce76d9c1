#pragma once

#include <memory>
#include <optional>
#include <span>

#include "simulation/physics.h"
#include "simulation/shape.h"

namespace unietp {

/// Solids to test placements against. Asks FCL yes or no, never a signed distance: FCL 0.7 aborts the process on
/// exactly touching boxes there. Instead each candidate is grown by a gap, so what passes keeps at least that much air.
/// Bodies have the ids of PhysicsWorld. Deterministic: of several hits the lowest id is reported.
class PlacementChecker {
 public:
  static constexpr double kGap_m = 1.5e-3;  // never below 1 mm

  PlacementChecker();
  /// Laid over a checker that others share (made by `shared`, and laid over none itself): a body that is set or removed
  /// here hides the one of its id below. Takes no time.
  explicit PlacementChecker(std::shared_ptr<const PlacementChecker> below);
  PlacementChecker(PlacementChecker&&) noexcept;
  PlacementChecker& operator=(PlacementChecker&&) noexcept;
  ~PlacementChecker();

  /// One that never changes again and that several threads may ask.
  static std::shared_ptr<const PlacementChecker> shared(PlacementChecker checker);

  /// Adds a body or replaces it.
  void set(BodyId id, const Shape& shape, const Pose& pose, double opening);
  void remove(BodyId id);

  /// The body with the lowest id that comes nearer than `gap` meters to the shape; nullopt when it is free. `ignore`
  /// are left out.
  std::optional<BodyId> hit(const Shape& shape, const Pose& pose, double opening, double gap = kGap_m,
                            std::span<const BodyId> ignore = {}) const;
  /// The same for the parts on joints only, doors and lids, at the given opening.
  std::optional<BodyId> hit_by_joints(const Shape& shape, const Pose& pose, double opening, double gap,
                                      std::span<const BodyId> ignore = {}) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The walls of a scene, as bodies of their own.
void set_walls(PlacementChecker& checker, const Scene& scene);

}  // namespace unietp
