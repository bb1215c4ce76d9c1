#include "simulation/view.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "core/sort_unique.h"
#include "simulation/body_grid.h"
#include "simulation/outline.h"
#include "simulation/solids.h"
#include "simulation/visible_box.h"
#include "simulation/wall_shadow.h"
#include "simulation/walls.h"

namespace unietp {

bool shows_clearly(const PixelBox& box) {
  constexpr int kLeastSide = 4, kLeastArea = 36;
  const int wide = box[2] - box[0] + 1, high = box[3] - box[1] + 1;
  return wide >= kLeastSide && high >= kLeastSide && wide * high >= kLeastArea;
}

struct Viewer::Body {
  std::string id;  // two objects of a category differ
  Archetype archetype = Archetype::Box;
  bool openable = false;
  Vec3 size = Vec3::Zero();
  Pose pose;
  double opening = 0;
  std::vector<Board> boards;
  StateSet states;
  std::vector<Solid> solids;

  bool is_of(const Node& node) const {
    return pose == node.pose && opening == node.opening && size == node.size && archetype == node.archetype &&
           openable == node.openable && boards == node.boards && id == node.id && states == node.states;
  }
};

struct Viewer::CachedView {
  /// A node and the range of its outlines.
  struct Seen {
    std::size_t node = 0;
    std::shared_ptr<const Body> body;
    std::uint32_t begin = 0, end = 0;
    PixelBox cover = kNowhere;
    std::optional<PixelBox> box{};  // of nodes whose box was computed
  };

  Camera camera;
  std::vector<Seen> asked, others;  // by node
  std::vector<Outline> outlines;    // of all nodes in order, then of walls

  /// The cached node, if its body is unchanged.
  static const Seen* find(const std::vector<Seen>& among, std::size_t node, const std::shared_ptr<const Body>& body) {
    const auto at = std::lower_bound(among.begin(), among.end(), node,
                                     [](const Seen& one, std::size_t wanted) { return one.node < wanted; });
    return at != among.end() && at->node == node && at->body == body ? &*at : nullptr;
  }
};

namespace {

/// Conservative image bounds of a sphere.
struct Ball {
  double nearest = 0;
  PixelBox cover{};
  Ball(const Vec3& center, double radius, const Camera& camera) {
    const Vec3 way = center - camera.at;
    const double deep = way.dot(camera.ahead);
    nearest = deep - radius;
    cover = {0, 0, camera.width, camera.height};
    if (nearest < 0.02) return;
    const auto side = [&](double aside, int size, double sign) {
      const double along = aside + sign * radius;  // at the depth that gives the larger bounds
      const double at = size / 2.0 + camera.focal * along / (sign * along > 0 ? nearest : deep + radius);
      return static_cast<int>(std::clamp(at + sign, -1.0, size + 1.0));
    };
    cover = {side(way.dot(camera.right), camera.width, -1), side(way.dot(camera.down), camera.height, -1),
             side(way.dot(camera.right), camera.width, 1), side(way.dot(camera.down), camera.height, 1)};
  }
};

void add_outlines(const std::vector<Solid>& solids, const Camera& camera, std::vector<Outline>& outlines) {
  for (const Solid& solid : solids) {
    if (auto outline = outline_of(solid, camera)) outlines.push_back(*outline);
  }
}

PixelBox cover_of(std::span<const Outline> outlines) {
  PixelBox cover = kNowhere;
  for (const Outline& one : outlines) cover = around(cover, one.cover);
  return cover;
}

}  // namespace

struct Viewer::Walls {
  std::vector<WallPiece> pieces;
  std::vector<Solid> all;      // of each
  std::vector<Bounds> bounds;  // of each
  BodyGrid places;             // of each, by its number

  explicit Walls(const Scene& scene) : pieces(walls_of(scene)) {
    for (const WallPiece& piece : pieces) {
      all.push_back({SolidKind::Box, piece.pose, piece.size, -1, false});
      bounds.push_back(bounds_of(piece.pose, piece.size));
    }
    Bounds around;
    for (const Bounds& one : bounds) around = {around.low.cwiseMin(one.low), around.high.cwiseMax(one.high)};
    places = BodyGrid(around);
    for (std::uint32_t i = 0; i < all.size(); ++i) places.insert(i, bounds[i]);
  }

  /// Visits the walls that may be visible up to a depth of `farthest`, in order.
  template <class Visit>
  void visit(const Camera& camera, double farthest, Visit visit) const {
    const auto show = [&](std::uint32_t i) {
      const Solid& wall = all[i];
      const double radius = wall.size.norm() / 2;
      if (camera.depth(wall.pose.position) - radius <= farthest && camera.may_show(wall.pose.position, radius))
        visit(i);
    };
    constexpr std::size_t kFew = 128;  // for so few a linear scan is faster than the grid
    if (all.size() <= kFew) {
      for (std::uint32_t i = 0; i < all.size(); ++i) show(i);
      return;
    }
    std::vector<std::uint32_t> near;
    places.visit(camera.shown_up_to(farthest), [&](std::uint32_t i) { near.push_back(i); });
    sort_unique(near);
    for (const std::uint32_t i : near) show(i);
  }
  void add_outlines(const Camera& camera, double farthest, std::vector<Outline>& outlines) const {
    visit(camera, farthest, [&](std::uint32_t i) {
      if (auto outline = outline_of(all[i], camera)) outlines.push_back(*outline);
    });
  }
  /// The walls that may hide some of a sphere from a point, in order.
  std::vector<std::uint32_t> between(const Vec3& eye, const Vec3& center, double radius) const {
    constexpr double kAside_m = 0.001;
    const Vec3 reach = Vec3::Constant(radius);
    const Bounds way{eye.cwiseMin(center - reach), eye.cwiseMax(center + reach)};
    std::vector<std::uint32_t> found;
    places.visit(way, [&](std::uint32_t i) {
      if (overlap(bounds[i], way, kAside_m)) found.push_back(i);
    });
    sort_unique(found);
    return found;
  }
  std::optional<WallShadow> shadow_of(std::uint32_t i, const Camera& camera) const {
    return WallShadow::of({all[i].pose, all[i].size}, camera.at);
  }
  /// Of the walls that take up most of the view.
  std::vector<WallShadow> shadows(const Camera& camera, double farthest) const {
    constexpr std::size_t kMost = 12;
    std::vector<WallShadow> found;
    visit(camera, farthest, [&](std::uint32_t i) {
      if (const auto shadow = shadow_of(i, camera)) found.push_back(*shadow);
    });
    const auto larger = [](const WallShadow& a, const WallShadow& b) { return a.angle() > b.angle(); };
    std::sort(found.begin(), found.end(), larger);
    if (found.size() > kMost) found.resize(kMost);
    return found;
  }
};

Viewer::Viewer(const Scene& scene) : walls_(std::make_shared<const Walls>(scene)) {}

const std::shared_ptr<const Viewer::Body>& Viewer::body_of(const Scene& scene, std::size_t i) {
  const Node& node = scene.nodes[i];
  if (bodies_.size() < scene.nodes.size()) bodies_.resize(scene.nodes.size());
  if (bodies_[i] == nullptr || !bodies_[i]->is_of(node)) {
    auto body = std::make_shared<Body>();
    *body = {node.id, node.archetype, node.openable, node.size, node.pose, node.opening, node.boards, node.states, {}};
    add_solids(node, static_cast<std::int32_t>(i), scene.simulator, walls_->pieces, body->solids);
    bodies_[i] = std::move(body);
  }
  return bodies_[i];
}

std::vector<std::size_t> ViewedScene::shown_within(const Camera& camera, double sight_m) const {
  constexpr std::size_t kFew = 512;   // for so few a linear scan is faster than the grid
  constexpr double kAround_m = 0.85;  // what shows states stands out of bodies
  if (near && sight_m < kEndless_m && scene.nodes.size() > kFew) {
    // Intersecting both boxes implies intersecting their common part, since both contain the camera.
    const Bounds shown = camera.shown_up_to(kEndless_m);
    const Vec3 sight = Vec3::Constant(sight_m), around = Vec3::Constant(kAround_m);
    return near({shown.low.cwiseMax(camera.at - sight) - around, shown.high.cwiseMin(camera.at + sight) + around});
  }
  std::vector<std::size_t> all(scene.nodes.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

ViewedScene viewed(const Scene& scene) {
  const auto hidden = [all = hidden_from_sight(scene)](std::size_t i) {
    return std::binary_search(all.begin(), all.end(), i);
  };
  return {scene, hidden};
}

std::vector<VisibleObject> Viewer::view(const ViewedScene& around, const Agent& eye, const Profile& profile,
                                        double sight_m) {
  const Scene& scene = around.scene;
  auto look = std::make_shared<CachedView>();
  look->camera = camera_of(eye, profile);
  const Camera& camera = look->camera;
  const bool same_eye = last_ != nullptr && last_->camera == camera;
  std::vector<PixelBox> changed;  // where the picture may differ from the cached one
  const auto see = [&](std::size_t i, std::vector<CachedView::Seen>& list,
                       const std::vector<CachedView::Seen>* before) {
    CachedView::Seen seen{i, body_of(scene, i)};
    seen.begin = static_cast<std::uint32_t>(look->outlines.size());
    const auto* known = before == nullptr ? nullptr : CachedView::find(*before, i, seen.body);
    if (known != nullptr) {
      const auto own = std::span(last_->outlines).subspan(known->begin, known->end - known->begin);
      look->outlines.insert(look->outlines.end(), own.begin(), own.end());
      seen.cover = known->cover;
      seen.box = known->box;
    } else {
      add_outlines(seen.body->solids, camera, look->outlines);
      seen.cover = cover_of(std::span(look->outlines).subspan(seen.begin));
      changed.push_back(seen.cover);
    }
    seen.end = static_cast<std::uint32_t>(look->outlines.size());
    list.push_back(std::move(seen));
  };
  const std::vector<WallShadow> shadows = walls_->shadows(camera, sight_m);
  const auto shown = [&](std::size_t i) {
    const Vec3& at = scene.nodes[i].pose.position;
    const double radius = sight_radius(scene.nodes[i]);
    const auto hides = [&](const WallShadow& shadow) { return shadow.hides(at, radius); };
    return camera.may_show(at, radius) && std::none_of(shadows.begin(), shadows.end(), hides) && !around.hides(i);
  };
  double farthest = 0;
  for (const std::size_t i : around.shown_within(camera, sight_m)) {
    const double distance = (scene.nodes[i].pose.position - camera.at).norm();
    if (distance > sight_m || !shown(i)) continue;
    see(i, look->asked, same_eye ? &last_->asked : nullptr);
    farthest = std::max(farthest, distance + sight_radius(scene.nodes[i]));
  }
  // Objects behind or beside all requested ones hide nothing.
  const auto may_hide_asked = [&](const Node& node) {
    const Ball ball(node.pose.position, sight_radius(node), camera);
    return std::any_of(look->asked.begin(), look->asked.end(), [&](const CachedView::Seen& seen) {
      if (!meet(ball.cover, seen.cover)) return false;
      const auto own = std::span(look->outlines).subspan(seen.begin, seen.end - seen.begin);
      return std::any_of(own.begin(), own.end(), [&](const Outline& one) { return ball.nearest <= one.farthest; });
    });
  };
  for (const std::size_t i : around.shown_within(camera, farthest)) {
    const Node& node = scene.nodes[i];
    const double distance = (node.pose.position - camera.at).norm();
    if (distance > sight_m && distance - sight_radius(node) <= farthest && shown(i) && may_hide_asked(node))
      see(i, look->others, same_eye ? &last_->others : nullptr);
  }
  walls_->add_outlines(camera, farthest, look->outlines);
  if (same_eye) {
    for (const auto& [before, now] :
         {std::pair(&last_->asked, &look->asked), std::pair(&last_->others, &look->others)}) {
      for (const CachedView::Seen& seen : *before) {
        if (CachedView::find(*now, seen.node, seen.body) == nullptr) changed.push_back(seen.cover);
      }
    }
  }

  std::vector<VisibleObject> visible;
  VisibleBoxes boxes(camera, look->outlines);
  for (CachedView::Seen& seen : look->asked) {
    const auto touches = [&](const PixelBox& part) { return meet(part, seen.cover); };
    if (!same_eye || std::any_of(changed.begin(), changed.end(), touches))
      seen.box = boxes.of(static_cast<std::int32_t>(seen.node));
    if (seen.box) visible.push_back({scene.nodes[seen.node].id, *seen.box});
  }
  std::sort(visible.begin(), visible.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  last_ = std::move(look);
  return visible;
}

std::optional<PixelBox> Viewer::unhidden_box_of(const Scene& scene, std::size_t target, const Agent& eye,
                                                const Profile& profile) {
  const Camera camera = camera_of(eye, profile);
  if (!camera.may_show(scene.nodes[target].pose.position, sight_radius(scene.nodes[target]))) return std::nullopt;
  std::vector<Outline> outlines;
  add_outlines(body_of(scene, target)->solids, camera, outlines);
  if (outlines.empty()) return std::nullopt;
  return cover_of(outlines);
}

std::optional<PixelBox> Viewer::box_of(const ViewedScene& around, std::size_t target, const Agent& eye,
                                       const Profile& profile) {
  const Scene& scene = around.scene;
  const Camera camera = camera_of(eye, profile);
  if (!camera.may_show(scene.nodes[target].pose.position, sight_radius(scene.nodes[target]))) return std::nullopt;
  if (around.hides(target)) return std::nullopt;
  const Vec3& middle = scene.nodes[target].pose.position;
  const double radius = sight_radius(scene.nodes[target]);
  const std::vector<std::uint32_t> walls = walls_->between(camera.at, middle, radius);
  for (const std::uint32_t wall : walls) {
    const auto shadow = walls_->shadow_of(wall, camera);
    if (shadow && shadow->hides(middle, radius)) return std::nullopt;
  }
  std::vector<Outline> outlines;
  add_outlines(body_of(scene, target)->solids, camera, outlines);
  if (outlines.empty()) return std::nullopt;
  const PixelBox cover = cover_of(outlines);
  double farthest = 0;
  for (const Outline& own : outlines) farthest = std::max(farthest, own.farthest);
  for (const std::size_t i : around.shown_within(camera, farthest)) {
    const Node& node = scene.nodes[i];
    if (i == target || !camera.may_show(node.pose.position, sight_radius(node))) continue;
    const Ball ball(node.pose.position, sight_radius(node), camera);
    if (ball.nearest > farthest || !meet(ball.cover, cover)) continue;
    if (around.hides(i)) continue;
    add_outlines(body_of(scene, i)->solids, camera, outlines);
  }
  for (const std::uint32_t wall : walls) {
    if (auto outline = outline_of(walls_->all[wall], camera)) outlines.push_back(*outline);
  }
  return VisibleBoxes(camera, outlines).of(static_cast<std::int32_t>(target));
}

std::optional<PixelBox> Viewer::first_with_box(const ViewedScene& around, std::size_t target, const Agent& eye,
                                               const Profile& profile) {
  const auto box = box_of(around, target, eye, profile);
  if (!box) return std::nullopt;
  const Scene& scene = around.scene;
  const Camera camera = camera_of(eye, profile);
  const auto covers_it = [&](const PixelBox& cover) { return unietp::around(cover, *box) == cover; };
  for (const std::size_t i : around.shown_within(camera, kEndless_m)) {
    const Node& node = scene.nodes[i];
    const double radius = sight_radius(node);
    if (node.id >= scene.nodes[target].id || !camera.may_show(node.pose.position, radius)) continue;
    if (!covers_it(Ball(node.pose.position, radius, camera).cover)) continue;
    std::vector<Outline> outlines;
    add_outlines(body_of(scene, i)->solids, camera, outlines);
    if (covers_it(cover_of(outlines)) && box_of(around, i, eye, profile) == box) return std::nullopt;
  }
  return box;
}

}  // namespace unietp
