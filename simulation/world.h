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
#include "simulation/passed_moment.h"
#include "simulation/picture.h"
#include "simulation/profile.h"
#include "simulation/rays.h"

namespace unietp {

struct KnownStart;

class MomentTree;

/// An episode in progress, as a value: takes actions, gives results and changes; `scene()` is the current USG. A failed
/// action changes nothing. Relations are read from physics, never set. Deterministic: equal starts and equal actions
/// give equal scenes, bit for bit. Copies are cheap and independent, so that a search may branch; they share a cache of
/// steps, so all copies must stay on one thread. Knowledge and profile must outlive them.
class World {
 public:
  /// Errors: Schema when the scene has a category that the knowledge lacks, or its agent stands nowhere.
  static Result<World> create(Scene start, const Knowledge& knowledge, const Profile& profile);
  /// The same with results that were computed before.
  static Result<World> create(Scene start, const Knowledge& knowledge, const Profile& profile, KnownStart known);
  World(const World&);
  World(World&&) noexcept;
  World& operator=(const World&);
  World& operator=(World&&) noexcept;
  ~World();

  /// Performs an action. Fails as the table of causes says (FailureCause of scene/action.h).
  ActionResult step(const Action& action);
  /// What the last step changed: `difference` of the scenes before and after it.
  const Delta& changes() const;
  /// The same from moment to moment: an action that consists of several steps leads through a moment after each.
  std::vector<Delta> changes_by_moment() const;
  /// The moments that the last step led through, the present one last; empty when it was a single step.
  const std::vector<PassedMoment>& passed() const;
  /// The current scene; the reference stays as it is until the next call of `scene()`.
  const Scene& scene() const;
  const Profile& profile() const;
  bool stopped() const;  // `stop` was performed
  /// Identifies the current state: copies of one world have equal ids exactly when their states are equal.
  MomentId moment() const { return moment_; }
  /// This world at another moment that it or a copy has been at.
  World at(MomentId moment) const;
  /// Drops all earlier moments, as long as no copy shares them: the present one becomes the first, `changes()` empty,
  /// and references that were given before are void. What is left takes the same memory however long the episode was.
  void forget();
  /// A copy of the present moment that shares nothing that is ever changed: it may go to another thread.
  World apart() const;

  /// Objects in view: with a visible pixel and nearer than the profile's limit of sight. Sorted by id.
  const std::vector<VisibleObject>& visible() const;
  /// The same without the limit of sight.
  const std::vector<VisibleObject>& pictured() const;
  /// Whether `visible` contains the object, without computing the whole view.
  bool shows(std::string_view id) const;
  /// The box that stands for an object in the picture; nullopt where the picture shows nothing of it, or an object
  /// with a lesser id has the same box.
  const std::optional<PixelBox>& unique_box(std::string_view id) const;
  /// The object that a box stands for, of those whose `unique_box` was asked for at this moment; nullptr.
  const std::string* object_of_box(const PixelBox& box) const;
  /// What the agent sees, as picture_of gives it, with the image size and angle of `lens`. `rays` is scratch space.
  Picture picture(const Profile& lens, Rays& rays) const;
  /// The object that a pixel of the image shows; nullptr for none. Valid until the next action.
  const Node* pictured_at(int x, int y, Rays& rays) const;

  // Parts of the scene without building the whole; references are valid until the next call on this world or a copy.
  const SharedList<Node>& nodes() const;
  /// Positions of nodes in `nodes()` by id and by category.
  const NodeIndex& places() const;
  /// The node as it is now; nullptr when there is none. Valid until the next action.
  const Node* find(std::string_view id) const;
  const Agent& agent() const;
  bool holds(std::string_view id) const;  // in the agent's hands
  const Room* find_room(std::string_view id) const;
  /// Whether the scene has the edge between two objects.
  bool linked(std::string_view from, Predicate relation, std::string_view to) const;
  /// Objects to which an object has the relation, in scene order.
  std::vector<std::string> linked_from(std::string_view from, Predicate relation) const;
  /// What lies directly on or in an object, in scene order.
  std::vector<std::string> resting_at(std::string_view id) const;
  /// Positions in `nodes()` of the nodes whose bounds are nearer than `gap` meters to the given ones; held objects are
  /// left out.
  std::vector<std::size_t> places_near(const Bounds& bounds, double gap) const;
  /// The room that an object is in, or "".
  std::string room_of(std::string_view id) const;

  // Queries for planners; none changes the world.
  /// Whether the agent can walk to a place with the object in reach and sight, in the current state: what is behind a
  /// closed door is not in sight.
  bool can_stand_at(std::string_view id) const;
  /// The box of an object in the picture from another position or direction; nullopt when no pixel of it is visible.
  /// Held objects are not in the picture.
  std::optional<PixelBox> pictured_from(const Agent& eye, std::string_view id) const;
  /// The agent after a step, turn, tilt or go_to from another position that is connected to the current one; nullopt
  /// when the action would fail or does not move the body.
  std::optional<Agent> agent_after(const Agent& from, const Action& action) const;
  /// The place that go_to would choose.
  std::optional<Vec2> standing_place_for(std::string_view id) const;
  /// Walking distance in meters to the nearest free cell beside the object's box; infinity when there is none.
  /// Distances above 40 m are not computed and count as 40 m, or as the straight distance if that is more.
  double walking_distance(std::string_view id) const;
  /// Lower bound of the walking distance, without obstacles; cheap.
  double straight_distance(const Node& node) const;
  /// Whether the agent could act on the object from where it stands: not in its hand, nothing closed around it, within
  /// reach and in sight.
  bool in_reach(std::string_view id) const;
  /// The same from another position.
  bool in_reach_from(const Vec2& place, std::string_view id) const;
  /// Collision-free poses at which place_on (place_in, with `inside`) could release the held object over an object, in
  /// reach or not. Empty when nothing is held.
  std::vector<Pose> free_spots(std::string_view id, bool inside) const;
  /// The same for an object that is not held.
  std::vector<Pose> free_spots_for(std::string_view thing, std::string_view id, bool inside) const;
  /// Id of the outermost closed container around the object, or "".
  std::string closed_around(std::string_view id) const;

 private:
  explicit World(std::shared_ptr<MomentTree> tree);
  std::shared_ptr<MomentTree> tree_;  // shared by all copies
  MomentId moment_;
  const Delta* changes_ = nullptr;
  const std::vector<PassedMoment>* passed_ = nullptr;  // by the last step
  mutable std::unique_ptr<Scene> shown_;               // as of the last call of `scene()`
  mutable std::vector<const Delta*> pending_changes_;  // since then
};

}  // namespace unietp
