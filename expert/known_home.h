#pragma once

#include <memory>

#include "scene/scene.h"
#include "simulation/collider.h"
#include "simulation/known_start.h"
#include "simulation/profile.h"

namespace unietp {

/// What is computed once of the home that an agent knows at the start, for all that it believes of it later: a believed
/// home is the known one with some furniture opened and with the things that were seen.
class KnownHome {
 public:
  /// `known_scene` must outlive it.
  KnownHome(const Scene& known_scene, const Profile& profile);

  /// Of the home as it is known at the start.
  KnownStart start() const;
  /// Of what is believed of it, which gets its relations. Equal to what is computed from `scene` alone. What is in the
  /// hand has none but to what else is there.
  KnownStart of(Scene& scene);

 private:
  const Scene& known_scene_;
  ColliderCache colliders_;
  PhysicsWorld physics_;
  std::shared_ptr<const Walk> walk_;
  Viewer viewer_;
};

}  // namespace unietp
