#pragma once

#include <memory>

#include "core/shared_list.h"
#include "scene/scene.h"
#include "simulation/collider.h"
#include "simulation/known_start.h"
#include "simulation/link_table.h"
#include "simulation/navigation.h"
#include "simulation/physics.h"
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
  /// Of what is believed of it, which gets its relations. Equal to what is computed from `scene` alone, but only what
  /// differs from what was believed last is computed. What is in the hand has none but to what else is there.
  KnownStart of(Scene& scene);

 private:
  /// What is computed of a home, with what is in the hand where it is held.
  struct Believed {
    SharedList<Node> nodes;
    PhysicsWorld physics;
    NavigationGrid grid;
    LinkTable links;
  };
  void believe(const Scene& scene);

  ColliderCache colliders_;
  PhysicsWorld physics_;  // of the known scene
  std::shared_ptr<const Walk> walk_;
  Viewer viewer_;
  Believed last_;
};

}  // namespace unietp
