#include "akb/fit.h"

#include <algorithm>
#include <cmath>

namespace unietp {
namespace {

// Numbers of simulation/shape.cpp, which builds the solids; a test of the house compares the two.
constexpr double kOpen_m = 2;       // free height with nothing above
constexpr double kEdge_m = 0.01;    // kept free along every edge
constexpr double kSlack_m = 0.002;  // around doors, drawers and lids
constexpr double kShelfSetBack_m = 0.03;
constexpr double kBoard_m = 0.02;
constexpr double kHighestTop_m = 1.25;  // a higher top is out of reach
constexpr double kMargin_m = 0.005;
constexpr double kApart_m = 0.02;  // between things on one surface
constexpr double kLargerModel = 1.15, kSmallerModel = 0.65, kSmallerHolder = 0.9;

double wall(const Vec3& size, double most) { return std::clamp(0.07 * size.minCoeff(), 0.003, most); }

std::optional<Room3> hollow(const Category& c) {
  const Vec3& s = c.size;
  switch (c.archetype) {
    case Archetype::Cabinet: {
      const double t = wall(s, 0.02), height = s.z() - 2 * t;
      const int bays = std::clamp(static_cast<int>(std::floor(height / 0.4)), 1, 5);
      return Room3{s.x() - 2 * t - 2 * kEdge_m, s.y() - 2 * t - kSlack_m - kShelfSetBack_m - 2 * kEdge_m,
                   height / bays - t, false, bays};
    }
    case Archetype::Drawers: {
      const double t = wall(s, 0.02), slot = std::min(s.z() - 2 * t, 0.24);
      return Room3{s.x() - 4 * t - 2 * kSlack_m - 2 * kEdge_m, s.y() - 3 * t - kSlack_m - 2 * kEdge_m,
                   slot - t - 2 * kSlack_m, false, 1};
    }
    case Archetype::Basin: {
      const double side = std::min(s.x(), s.y()), t = std::clamp(0.08 * side, 0.02, 0.06);
      return Room3{s.x() - 2 * t, s.y() - 2 * t, std::min(0.65 * s.z(), 0.4 * side), true, 1};
    }
    case Archetype::Vessel: {
      const double t = wall(s, 0.012);
      return Room3{s.x() - 2 * t - kSlack_m, s.y() - 2 * t - kSlack_m, s.z() - t, true, 1};
    }
    case Archetype::Lidded: {
      const double t = wall(s, 0.012);
      return Room3{s.x() - 2 * t - kSlack_m, s.y() - 2 * t - kSlack_m, s.z() - 2 * t - kSlack_m, false, 1};
    }
    default:
      return std::nullopt;
  }
}

Room3 plane(double width, double depth) { return {width - 2 * kEdge_m, depth - 2 * kEdge_m, kOpen_m, false, 1}; }

std::optional<Room3> top(const Category& c) {
  const Vec3& s = c.size;
  switch (c.archetype) {
    case Archetype::Block:
    case Archetype::Table:
    case Archetype::Drawers:
    case Archetype::Plate:
      return plane(s.x(), s.y());
    case Archetype::Cabinet:
      if (s.z() > kHighestTop_m) return std::nullopt;
      return plane(s.x(), s.y() - 0.025);  // the door
    case Archetype::Seat:
      return plane(s.x(), s.y() - std::min(0.15, 0.2 * s.y()) - 0.01);
    case Archetype::Bed:
      return plane(s.x(), s.y() - 0.06);
    case Archetype::Shelf: {
      if (s.z() < 0.15) return plane(s.x(), s.y());
      const int bays = std::clamp(static_cast<int>(std::lround(s.z() / 0.42)), 1, 6);
      const double pitch = (s.z() - kBoard_m) / bays;
      return Room3{s.x() - 2 * kBoard_m - 2 * kEdge_m, s.y() - kBoard_m - 2 * kEdge_m, pitch - kBoard_m, false, bays};
    }
    default:
      return std::nullopt;
  }
}

/// The floor between the legs of a table or a bed.
std::optional<Room3> below(const Category& c) {
  const Vec3& s = c.size;
  if (c.archetype == Archetype::Bed) {
    const double side = 2 * std::min({0.06, 0.2 * s.x(), 0.2 * s.y()}) + 2 * kEdge_m;
    return Room3{s.x() - side, s.y() - side, std::min(0.25, 0.45 * 0.6 * s.z()), false, 1};
  }
  if (c.archetype != Archetype::Table) return std::nullopt;
  const double board = std::min(0.04, 0.2 * s.z()), leg = std::min({0.06, 0.2 * s.x(), 0.2 * s.y()});
  return Room3{s.x() - 2 * leg - 2 * kEdge_m, s.y() - 2 * leg - 2 * kEdge_m, s.z() - board, false, 1};
}

}  // namespace

std::optional<Room3> room_of(const Category& receptacle, std::string_view relation) {
  if (relation == "inside") return hollow(receptacle);
  if (relation == "on") return top(receptacle);
  if (relation == "under") return below(receptacle);
  return std::nullopt;
}

bool fits(const Vec3& object, const Room3& room) {
  const double height = room.open_above ? object.z() / 2 : object.z();
  const auto [small, large] = std::minmax(object.x(), object.y());
  const auto [narrow, wide] = std::minmax(room.width, room.depth);
  return small + kMargin_m <= narrow && large + kMargin_m <= wide && height + kMargin_m <= room.clearance;
}

bool fits(const Category& object, std::string_view relation, const Category& receptacle) {
  const auto room = room_of(receptacle, relation);
  return room && fits(object.size, *room);
}

bool fit_side_by_side(const Category& a, const Category& b, const Category& support) {
  const auto room = room_of(support, "on");
  if (!room || std::max(a.size.z(), b.size.z()) + kMargin_m > room->clearance) return false;
  const auto as = std::minmax(a.size.x(), a.size.y()), bs = std::minmax(b.size.x(), b.size.y());
  const double narrow = std::min(room->width, room->depth), wide = std::max(room->width, room->depth);
  // In a row along the wide side: each with its short side along it when its long side still fits across.
  const auto along = [&](double small, double large) { return large + kMargin_m <= narrow ? small : large; };
  const double a_along = along(as.first, as.second), b_along = along(bs.first, bs.second);
  return as.first + kMargin_m <= narrow && bs.first + kMargin_m <= narrow && a_along + b_along + kApart_m <= wide;
}

bool usable(const Asset& asset, const Category& category) {
  const bool holds = room_of(category, "on") || room_of(category, "inside");
  const auto close = [&](const Vec3& size) {
    const Vec3 ratio = size.cwiseQuotient(category.size);
    return ratio.minCoeff() >= (holds ? kSmallerHolder : kSmallerModel) && ratio.maxCoeff() <= kLargerModel;
  };
  const bool no_front = category.movable || category.archetype == Archetype::Table ||
                        category.archetype == Archetype::Plate || category.archetype == Archetype::Vessel ||
                        category.archetype == Archetype::Fixture;
  return close(asset.size) || (no_front && close({asset.size.y(), asset.size.x(), asset.size.z()}));
}

int capacity_of(const Category& object, std::string_view relation, const Category& receptacle) {
  const auto room = room_of(receptacle, relation);
  if (!room || !fits(object.size, *room)) return 0;
  const auto count = [&](double w, double d) {
    return static_cast<int>(room->width / (w + kApart_m)) * static_cast<int>(room->depth / (d + kApart_m));
  };
  const int grid = std::max(count(object.size.x(), object.size.y()), count(object.size.y(), object.size.x()));
  return std::clamp(static_cast<int>(0.6 * grid * room->levels), 1, 12);
}

}  // namespace unietp
