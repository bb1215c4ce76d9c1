#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "scene/scene.h"
#include "scene/visible_object.h"
#include "simulation/camera.h"
#include "simulation/profile.h"
#include "simulation/rays.h"

namespace unietp {

inline constexpr double kEndless_m = 1000;  // farther than any home reaches

/// Enough of an object shows to be told from what is around it: at least 4 pixels each way and 36 in all.
bool shows_clearly(const PixelBox& box);

/// What there is to look at.
struct ViewedScene {
  const Scene& scene;
  std::function<bool(std::size_t)> hidden{};  // whether no eye sees a node, as of hidden_from_sight; none: of no node
  /// The nodes whose bodies reach into bounds, ascending; none: all that the scene has.
  std::function<std::vector<std::size_t>(const Bounds&)> near{};

  bool hides(std::size_t node) const { return hidden && hidden(node); }
  /// The nodes of which a camera may show something and which reach nearer than so many metres along each axis, and
  /// perhaps more; ascending.
  std::vector<std::size_t> shown_within(const Camera& camera, double sight_m) const;
};

/// Of a scene as it was written down.
ViewedScene viewed(const Scene& scene);

/// A workplace for looking: it keeps the solids of what has not changed since the last look and, while the eye stays
/// where it is, what they look like and the boxes of all that no change meets. What it held before does not matter to
/// any result. Not thread-safe; copies share what they keep.
class Viewer {
 public:
  /// For scenes that have the rooms and openings of this one.
  explicit Viewer(const Scene& scene);

  /// The objects whose box's centre is at most `sight_m` from the eye and of which the image shows a pixel, with the
  /// box around those pixels: exactly what a ray through the middle of every pixel finds (segmentation_of), at the cost
  /// of a few hundred. Sorted by id. `eye`: place, yaw and pitch.
  std::vector<VisibleObject> view(const ViewedScene& around, const Agent& eye, const Profile& profile, double sight_m);
  /// The box of one object alone, without a limit of sight; nullopt when the image shows nothing of it.
  std::optional<PixelBox> box_of(const ViewedScene& around, std::size_t node, const Agent& eye, const Profile& profile);

 private:
  struct Body;  // a node's solids, and what they were made of
  struct Look;  // what a view was of, and what came of it
  struct Walls;
  const std::shared_ptr<const Body>& body_of(const Scene& scene, std::size_t node);

  // Shared by copies, and never changed: a branch of an episode keeps what its copies have in common.
  std::vector<std::shared_ptr<const Body>> bodies_;
  std::shared_ptr<const Walls> walls_;
  std::shared_ptr<const Look> last_;
};

}  // namespace unietp
