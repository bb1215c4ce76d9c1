#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "akb/knowledge.h"
#include "core/result.h"
#include "scene/action.h"
#include "scene/node_index.h"
#include "scene/scene.h"
#include "scene/trace.h"
#include "scene/visible_object.h"
#include "simulation/action_result.h"
#include "simulation/moment_id.h"
#include "simulation/profile.h"

namespace unietp {

struct KnownStart;

class MomentTree;

/// An episode in progress: a value that steps. Start scene in, action in, result and changes out; `scene()` is the USG
/// after it. A failed action changes nothing. Relations are read from physics, never set. Deterministic: equal starts
/// and equal actions give equal scenes, bit for bit. A copy costs next to nothing and is independent (a search may
/// branch); copies remember together what was done already, so they belong to one thread. Knowledge and profile must
/// outlive them.
class World {
 public:
  /// Errors: Schema when the scene has a category that the knowledge lacks, or its agent stands nowhere.
  static Result<World> create(Scene start, const Knowledge& knowledge, const Profile& profile);
  /// The same for a start of which something is known already.
  static Result<World> create(Scene start, const Knowledge& knowledge, const Profile& profile, KnownStart known);
  World(const World&);
  World(World&&) noexcept;
  World& operator=(const World&);
  World& operator=(World&&) noexcept;
  ~World();

  ActionResult step(const Action& action);
  /// What the last step changed: `difference` of the scenes before and after it.
  const Delta& changes() const;
  /// The whole scene; the reference tells of this moment until `scene()` is asked again.
  const Scene& scene() const;
  const Profile& profile() const;
  bool stopped() const;  // `stop` was done
  MomentId moment() const { return moment_; }
  /// The same start at another of its moments.
  World at(MomentId moment) const;

  /// What the camera shows now: objects nearer than the profile's sight of which a pixel is met first by its ray, by
  /// id.
  const std::vector<VisibleObject>& visible() const;
  /// The same without a limit of sight: every object of which the picture shows a pixel.
  const std::vector<VisibleObject>& pictured() const;
  /// Whether `visible` has the object, without the cost of the whole view.
  bool shows(std::string_view id) const;

  // Parts of the scene without the cost of the whole; what is returned is valid until a copy of this world is asked
  // anything or steps.
  const SharedList<Node>& nodes() const;
  /// At which of them what is.
  const NodeIndex& places() const;
  const Node* find(std::string_view id) const;
  const Agent& agent() const;
  bool holds(std::string_view id) const;  // in the agent's hands
  const Room* find_room(std::string_view id) const;
  /// Whether the scene has the edge between two objects.
  bool linked(std::string_view from, Predicate relation, std::string_view to) const;
  /// Objects to which one has the relation, by place in the scene.
  std::vector<std::string> linked_from(std::string_view from, Predicate relation) const;
  /// What lies on or in an object, directly, by place in the scene.
  std::vector<std::string> resting_at(std::string_view id) const;
  /// Places in the scene of the nodes whose bounds come nearer than `gap` metres to some; what is held is nowhere.
  std::vector<std::size_t> places_near(const Bounds& bounds, double gap) const;
  /// The room that an object is in, or "".
  std::string room_of(std::string_view id) const;

  // Questions that a planner may ask; none changes the world.
  /// The body can stand somewhere with the object in reach and sight (as things are now: what is behind a closed door
  /// is not in sight).
  bool can_stand_at(std::string_view id) const;
  /// The box of one object in the picture from another place or in another direction; nullopt when it shows nothing of
  /// it. What the agent holds stays out of the picture.
  std::optional<PixelBox> pictured_from(const Agent& eye, std::string_view id) const;
  /// Where a step, turn, tilt or go_to would lead the body, if it stood elsewhere but could walk to where it stands
  /// now; nullopt when the action would fail or moves no body.
  std::optional<Agent> led_to(const Agent& from, const Action& action) const;
  /// As go_to would choose it.
  std::optional<Vec2> standing_place_for(std::string_view id) const;
  /// Walking distance in metres to the nearest free cell beside the object's box; infinity when there is none. What no
  /// walk of 40 m leads to counts as that far, or as far as it is straight ahead if that is more.
  double walking_distance(std::string_view id) const;
  /// No more than that, and found at once: what it would be if nothing stood in the way.
  double straight_distance(const Node& node) const;
  bool in_reach(std::string_view id) const;
  /// The same if the agent stood elsewhere.
  bool in_reach_from(const Vec2& place, std::string_view id) const;
  /// Poses at which place_on (place_in, with `inside`) could let go of what the hand holds over an object, were they in
  /// reach: those at which it meets nothing. Empty for empty hands.
  std::vector<Pose> free_spots(std::string_view id, bool inside) const;
  /// The same for a thing that lies elsewhere, as if it were held.
  std::vector<Pose> free_spots_for(std::string_view thing, std::string_view id, bool inside) const;
  /// Id of the outermost closed container around the object, or "".
  std::string closed_around(std::string_view id) const;

 private:
  explicit World(std::shared_ptr<MomentTree> tree);
  std::shared_ptr<MomentTree> tree_;  // of all copies, which are moments of it
  MomentId moment_;
  const Delta* changes_ = nullptr;
  mutable std::unique_ptr<Scene> shown_;             // as of the last call of `scene()`
  mutable std::vector<const Delta*> not_yet_shown_;  // what changed since then
};

}  // namespace unietp
