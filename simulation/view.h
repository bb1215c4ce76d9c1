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

inline constexpr double kEndless_m = 1000;  // larger than any home

/// Whether a box is large enough to recognize an object: at least 4 pixels each way and 36 in all.
bool shows_clearly(const PixelBox& box);

/// A scene with what is needed to render it.
struct ViewedScene {
  const Scene& scene;
  std::function<bool(std::size_t)> hidden{};  // whether a node is invisible (hidden_from_sight); null: none is
  /// The nodes whose bodies reach into bounds, ascending; null: all nodes of the scene.
  std::function<std::vector<std::size_t>(const Bounds&)> near{};

  bool hides(std::size_t node) const { return hidden && hidden(node); }  // whether a node is not to be seen
  /// A superset of the nodes that a camera may show within `sight_m` along each axis; ascending.
  std::vector<std::size_t> shown_within(const Camera& camera, double sight_m) const;
};

/// Of a complete scene.
ViewedScene viewed(const Scene& scene);

/// Computes views and caches the solids of unchanged nodes and, while the camera does not move, their outlines and the
/// boxes that no change affects. The cache never changes a result. Not thread-safe; copies share their cache.
class Viewer {
 public:
  /// For scenes that have the rooms and openings of this one.
  explicit Viewer(const Scene& scene);

  /// The objects whose box's center is at most `sight_m` from the camera and of which the image shows a pixel, with the
  /// box around those pixels: exactly what a ray through the middle of every pixel finds (segmentation_of), also
  /// through glass, at the cost of a few hundred. Sorted by id. `eye`: place, yaw and pitch.
  std::vector<VisibleObject> view(const ViewedScene& around, const Agent& eye, const Profile& profile, double sight_m);
  /// The box of one object alone, without a limit of sight; nullopt when the image shows nothing of it.
  std::optional<PixelBox> box_of(const ViewedScene& around, std::size_t node, const Agent& eye, const Profile& profile);
  /// The pixels around all that the image could show of it, if nothing hid it; nullopt when it is outside.
  std::optional<PixelBox> unhidden_box_of(const Scene& scene, std::size_t node, const Agent& eye,
                                          const Profile& profile);
  /// The box of one object if no object with a lesser id has the same box in the image, as far as `view` without a
  /// limit of sight would tell, at less cost.
  std::optional<PixelBox> first_with_box(const ViewedScene& around, std::size_t node, const Agent& eye,
                                         const Profile& profile);

 private:
  struct Body;        // a node's solids, and what they were made of
  struct CachedView;  // the last view: its inputs and its result
  struct Walls;
  const std::shared_ptr<const Body>& body_of(const Scene& scene, std::size_t node);

  // Immutable, so that copies can share them.
  std::vector<std::shared_ptr<const Body>> bodies_;
  std::shared_ptr<const Walls> walls_;
  std::shared_ptr<const CachedView> last_;
};

}  // namespace unietp
