#include "simulation/navigation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "simulation/walls.h"

namespace unietp {
namespace {

constexpr double kDoorway_m = 0.2;  // to either side of an opening's line

Digest digest_of(std::size_t node, const std::vector<FloorFootprint>& shadows) {
  if (shadows.empty()) return {};
  Digester digester;
  digester.add(std::uint64_t{node});
  for (const FloorFootprint& shadow : shadows) {
    for (const Vec2& part : {shadow.center, shadow.along, shadow.half}) digester.add(part.x()).add(part.y());
  }
  return digester.digest();
}

}  // namespace

NavigationGrid::NavigationGrid(const Scene& scene, const Profile& profile)
    : body_radius_(profile.body_radius_m),
      body_height_(profile.body_height_m),
      footprints_(std::vector<std::vector<FloorFootprint>>(scene.nodes.size())) {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Room& room : scene.rooms) {
    const Bounds bounds = room_bounds(room, 0);
    low = low.cwiseMin(bounds.low.head<2>());
    high = high.cwiseMax(bounds.high.head<2>());
  }
  if (scene.rooms.empty()) return;
  origin_ = low;
  width_ = static_cast<int>(std::ceil((high.x() - low.x()) / kCell_m));
  height_ = static_cast<int>(std::ceil((high.y() - low.y()) / kCell_m));
  stretches_ = (static_cast<std::size_t>(width_) + kStretch - 1) / kStretch;
  Stretch outside;
  outside.fill(1);
  for (std::size_t i = 0; i < stretches_ * static_cast<std::size_t>(height_); ++i) blockers_.push_back(outside);
  free_ = CellSet(width_, height_);
  for (const Room& room : scene.rooms) {
    const Bounds bounds = room_bounds(room, 0);
    const Cell from = cell_at(bounds.low.head<2>()), to = cell_at(bounds.high.head<2>());
    std::vector<double> crossings;
    for (int y = std::max(0, from.y); y <= std::min(height_ - 1, to.y); ++y) {
      crossings.clear();
      each_crossing(room.polygon, center({0, y}).y(), [&](double x) { crossings.push_back(x); });
      std::sort(crossings.begin(), crossings.end());
      std::size_t passed = 0;
      for (int x = std::max(0, from.x); x <= std::min(width_ - 1, to.x); ++x) {
        while (passed < crossings.size() && crossings[passed] <= center({x, y}).x()) ++passed;
        if ((crossings.size() - passed) % 2 == 1) open_floor({x, y});  // as in `contains`
      }
    }
  }
  // In some files rooms end at the inner faces of their walls, and the doorway lies between them.
  for (const Opening& opening : scene.openings) {
    const Vec2 along = opening.to - opening.from;
    const double length = along.norm();
    if (!(length > 0)) continue;
    const Vec2 reach = Vec2::Constant(kDoorway_m);
    const Cell from = cell_at(opening.from.cwiseMin(opening.to) - reach);
    const Cell to = cell_at(opening.from.cwiseMax(opening.to) + reach);
    for (int y = std::max(0, from.y); y <= std::min(height_ - 1, to.y); ++y) {
      for (int x = std::max(0, from.x); x <= std::min(width_ - 1, to.x); ++x) {
        const Vec2 way = center({x, y}) - opening.from;
        const double at = way.dot(along) / length, aside = way.x() * along.y() - way.y() * along.x();
        if (at >= 0 && at <= length && std::abs(aside) / length <= kDoorway_m) open_floor({x, y});
      }
    }
  }
  for (const WallPiece& piece : walls_of(scene)) {
    if (const auto f = footprint_of_box(piece.pose, piece.size, body_height_)) count(*f, 1);
  }
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    if (std::find(scene.agent.held.begin(), scene.agent.held.end(), node.id) != scene.agent.held.end()) continue;
    const Shape shape = shape_of(node);
    update(i, &node, &shape);
  }
}

void NavigationGrid::open_floor(Cell cell) {
  blockers_.edit(stretch(cell))[static_cast<std::size_t>(cell.x) % kStretch] = 0;
  free_.set(cell.x, cell.y, true);
}

void NavigationGrid::count(const FloorFootprint& f, int by) {
  const Vec2 &u = f.along, v(-f.along.y(), f.along.x());
  const Vec2 reach = u.cwiseAbs() * f.half.x() + v.cwiseAbs() * f.half.y() + Vec2::Constant(body_radius_);
  const Cell from = cell_at(f.center - reach), to = cell_at(f.center + reach);
  const double limit = body_radius_ * body_radius_;
  for (int y = std::max(0, from.y); y <= std::min(height_ - 1, to.y); ++y) {
    Stretch* here = nullptr;
    for (int x = std::max(0, from.x); x <= std::min(width_ - 1, to.x); ++x) {
      const std::size_t at = static_cast<std::size_t>(x) % kStretch;
      if (at == 0) here = nullptr;
      const Vec2 d = center({x, y}) - f.center;
      const double out_u = std::max(0.0, std::abs(d.dot(u)) - f.half.x());
      const double out_v = std::max(0.0, std::abs(d.dot(v)) - f.half.y());
      if (out_u * out_u + out_v * out_v >= limit) continue;
      if (here == nullptr) here = &blockers_.edit(stretch({x, y}));
      std::uint16_t& blockers = (*here)[at];
      const bool was_free = blockers == 0;
      blockers = static_cast<std::uint16_t>(blockers + by);
      if (was_free != (blockers == 0)) free_.set(x, y, !was_free);
    }
  }
}

void NavigationGrid::update(std::size_t i, const Node* node, const Shape* shape) {
  while (i >= footprints_.size()) footprints_.emplace_back();
  std::vector<FloorFootprint> shadow;
  if (node != nullptr) shadow = footprint_of(*node, *shape, body_height_);
  if (shadow == footprints_[i]) return;
  std::vector<FloorFootprint> gone = footprints_[i];
  for (const FloorFootprint& f : shadow) {  // e.g. the body of a cupboard whose door opens
    const auto before = std::find(gone.begin(), gone.end(), f);
    if (before == gone.end()) {
      count(f, 1);
    } else {
      gone.erase(before);
    }
  }
  for (const FloorFootprint& f : gone) count(f, -1);
  digest_ -= digest_of(i, footprints_[i]);
  digest_ += digest_of(i, shadow);
  footprints_.edit(i) = std::move(shadow);
}

std::optional<NavigationGrid::Cell> NavigationGrid::nearest_free(const Vec2& point) const {
  const Cell middle = cell_at(point);
  std::optional<Cell> best;
  double best_distance = std::numeric_limits<double>::infinity();
  const auto look = [&](int x, int y) {
    const Cell cell{x, y};
    if (!free(cell)) return;
    const double d = (center(cell) - point).squaredNorm();
    const bool nearer = d < best_distance || (d == best_distance && std::pair(y, x) < std::pair(best->y, best->x));
    if (!nearer) return;
    best_distance = d;
    best = cell;
  };
  const int farthest = std::max({middle.x, middle.y, width_ - 1 - middle.x, height_ - 1 - middle.y});
  for (int ring = 0; ring <= farthest; ++ring) {
    const double least = (ring - 0.5) * kCell_m;  // from the point to the center of a cell of this ring
    if (best && ring > 0 && least * least > best_distance) break;
    for (int y = std::max(0, middle.y - ring); y <= std::min(height_ - 1, middle.y + ring); ++y) {
      const bool whole_row = std::abs(y - middle.y) == ring;
      const int step = whole_row || ring == 0 ? 1 : 2 * ring;
      for (int x = middle.x - ring; x <= middle.x + ring; x += step) look(x, y);
    }
  }
  return best;
}

}  // namespace unietp
