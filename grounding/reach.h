#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <vector>

#include "grounding/grown_scene.h"
#include "scene/scene.h"
#include "simulation/physics.h"
#include "simulation/profile.h"
#include "simulation/view.h"

namespace unietp {

/// What a piece of furniture's door, lid or drawer meets of fixed bodies when it is moved all its way; nullopt for
/// nothing, for what can be carried, and for what has no joints.
std::optional<BodyId> what_blocks(const Scene& scene, const PhysicsWorld& world, std::size_t node);

/// Where the body can stand in a scene that grew out of a home, and what its arm and its eye reach from there, behind
/// doors that it can open too. Questions of geometry by the rules of the actions; nothing is done. All that is passed
/// must outlive it.
class Reach {
 public:
  Reach(const Home& home, const Scene& scene, const GrownScene& grown, const Profile& profile);
  /// Of a scene with its edges that did not grow out of a home, to ask for what can be reached: unreached() and shows()
  /// are not to be asked of it.
  Reach(const Scene& scene, const NodeIndex& places, const PhysicsWorld& world, std::shared_ptr<const Walk> walk,
        const Profile& profile);

  /// Id of a room that the agent cannot walk to any more (newly_unreached).
  std::optional<std::string> unreached() const;
  /// The body can walk into it.
  bool room(const Room& room) const;
  /// The body can stand where it reaches and sees the thing.
  bool object(std::size_t thing);
  /// Nothing shut is around it.
  bool lies_open(std::size_t thing) const { return shut_around(thing).empty(); }
  /// From one of those places the thing shows clearly in the camera's picture, at least 6 pixels each way. Only asked
  /// of what is small: larger things show.
  bool shows(std::size_t thing);
  /// place_on, or with `inside` place_in, can let the thing go on the target: there is a spot where it meets nothing
  /// fixed, and a place to stand from which the arm gets there and the target is in reach and sight. Whatever can be
  /// carried away counts as gone; on a target that can be carried itself only the size is asked for.
  bool spot_for(std::size_t thing, std::size_t target, bool inside);
  /// The same for several things at once, none of which is asked for alone: each has a spot of its own. True, too,
  /// where they plainly find room, and inside where one of them could take another.
  bool room_for_all(const std::vector<std::size_t>& things, std::size_t target, bool inside);
  /// Nothing blocks it (what_blocks).
  bool swings(std::size_t node) const;

 private:
  /// Where the body stands by each node, as far as asked for.
  using PlacesBy = std::map<std::size_t, std::vector<Vec2>>;
  /// The scene, without its edges, with some doors open.
  struct Opened {
    std::vector<std::size_t> doors;
    Scene scene;
    PhysicsWorld world;
    std::shared_ptr<const Walk> walk;  // when first asked for
    PlacesBy places_by;
  };
  bool stands_by(std::size_t index);
  std::vector<std::size_t> shut_around(std::size_t index) const;
  std::vector<std::size_t> doors_before(std::size_t target, bool inside) const;
  const std::vector<Vec2>& standing_by(std::size_t index);
  const std::vector<Vec2>& standing_by(Opened& opened, std::size_t index) const;
  const Walk& walk(Opened& opened) const;
  Opened& with_open(const std::vector<std::size_t>& doors);
  void slide_along(Opened& opened, const std::vector<std::size_t>& doors, std::size_t index) const;

  const Home* home_;  // nullptr for a scene of its own
  const Scene& scene_;
  const NodeIndex& places_;
  const PhysicsWorld& world_;
  const Profile& profile_;
  std::shared_ptr<const Walk> walk_;
  PlacesBy places_by_;
  std::optional<Opened> opened_;  // the last asked for
  std::map<std::size_t, bool> reached_, shown_;
  /// A place without a spot that is free of what is fixed, for things of one form: target, inside, digest, size.
  using Full = std::tuple<std::size_t, bool, std::uint64_t, std::uint64_t, double, double, double>;
  std::set<Full> full_;
  std::optional<Viewer> viewer_;  // of a home
};

}  // namespace unietp
