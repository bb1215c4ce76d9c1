#pragma once

#include <memory>

#include "scene/scene.h"
#include "simulation/collider.h"
#include "simulation/known_start.h"
#include "simulation/profile.h"

namespace unietp {

/// What is computed of the home that an agent was told, once for all that it then believes of it: a believed home is
/// the told one with some furniture opened and with the things that were seen.
class ToldHome {
 public:
  /// `told` must outlive it.
  ToldHome(const Scene& told, const Profile& profile);

  /// Of the home as it was told.
  KnownStart start() const;
  /// Of what is believed of it, which gets its relations. Equal to what is computed from `scene` alone.
  KnownStart of(Scene& scene);

 private:
  const Scene& told_;
  ColliderCache colliders_;
  PhysicsWorld physics_;
  std::shared_ptr<const Walk> walk_;
  Viewer viewer_;
};

}  // namespace unietp
