#include "akb/fit.h"

#include <algorithm>

#include "scene/archetype_dimensions.h"

namespace unietp {
namespace {

constexpr double kHighestTop_m = 1.25;  // a higher top is out of reach
constexpr double kMargin_m = 0.005;
constexpr double kApart_m = 0.02;  // between things on one surface
constexpr double kLargerModel = 1.15, kSmallerModel = 0.65, kSmallerHolder = 0.9;

std::optional<Room3> hollow(const Category& c) {
  const Vec3& s = c.size;
  switch (c.archetype) {
    case Archetype::Cabinet: {
      const auto [t, bays, pitch, set_back] = cabinet_dimensions(s);
      return Room3{s.x() - 2 * t - 2 * kSurfaceEdge_m, s.y() - 2 * t - kDoorGap_m - set_back - 2 * kSurfaceEdge_m,
                   pitch - t, false, bays};
    }
    case Archetype::Drawers: {
      const auto [t, slot] = drawers_dimensions(s);
      return Room3{s.x() - 4 * t - 2 * kDoorGap_m - 2 * kSurfaceEdge_m, s.y() - 3 * t - kDoorGap_m - 2 * kSurfaceEdge_m,
                   slot - t - 2 * kDoorGap_m, false, 1};
    }
    case Archetype::Basin: {
      const auto [t, depth] = basin_dimensions(s);
      return Room3{s.x() - 2 * t, s.y() - 2 * t, depth, true, 1};
    }
    case Archetype::Vessel: {
      const double t = vessel_wall(s);
      return Room3{s.x() - 2 * t - kDoorGap_m, s.y() - 2 * t - kDoorGap_m, s.z() - t, true, 1};
    }
    case Archetype::Lidded: {
      const double t = vessel_wall(s);
      return Room3{s.x() - 2 * t - kDoorGap_m, s.y() - 2 * t - kDoorGap_m, s.z() - 2 * t - kDoorGap_m, false, 1};
    }
    default:
      return std::nullopt;
  }
}

Room3 plane(double width, double depth) {
  return {width - 2 * kSurfaceEdge_m, depth - 2 * kSurfaceEdge_m, kOpenAbove_m, false, 1};
}

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
      return plane(s.x(), s.y() - kDoorAllowance_m);
    case Archetype::Seat:
      return plane(s.x(), s.y() - seat_dimensions(s).back - kBackrestGap_m);
    case Archetype::Bed:
      return plane(s.x(), s.y() - bed_dimensions(s).headboard);
    case Archetype::Shelf: {
      const auto [bays, board, pitch] = shelf_dimensions(s);
      if (bays == 0) return plane(s.x(), s.y());
      return Room3{s.x() - 2 * board - 2 * kSurfaceEdge_m, s.y() - board - 2 * kSurfaceEdge_m, pitch - board, false,
                   bays};
    }
    default:
      return std::nullopt;
  }
}

/// The floor between the legs of a table or a bed. With room to spare: the legs and the top are taken to be as thick as
/// those of a thing twice as large, which is more only for small ones.
std::optional<Room3> below(const Category& c) {
  const Vec3& s = c.size;
  if (c.archetype == Archetype::Bed) {
    const double side = 2 * bed_dimensions(2 * s).leg + 2 * kSurfaceEdge_m;
    return Room3{s.x() - side, s.y() - side, bed_dimensions(s).gap, false, 1};
  }
  if (c.archetype != Archetype::Table) return std::nullopt;
  const auto [board, leg] = table_dimensions(2 * s);
  return Room3{s.x() - 2 * leg - 2 * kSurfaceEdge_m, s.y() - 2 * leg - 2 * kSurfaceEdge_m, s.z() - board, false, 1};
}

}  // namespace

std::optional<Room3> room_of(const Category& receptacle, Predicate relation) {
  if (relation == Predicate::Inside) return hollow(receptacle);
  if (relation == Predicate::On) return top(receptacle);
  if (relation == Predicate::Under) return below(receptacle);
  return std::nullopt;
}

bool fits(const Vec3& object, const Room3& room) {
  const double height = room.open_above ? object.z() / 2 : object.z();
  const auto [small, large] = std::minmax(object.x(), object.y());
  const auto [narrow, wide] = std::minmax(room.width, room.depth);
  return small + kMargin_m <= narrow && large + kMargin_m <= wide && height + kMargin_m <= room.clearance;
}

bool fits(const Category& object, Predicate relation, const Category& receptacle) {
  const auto room = room_of(receptacle, relation);
  return room && fits(object.size, *room);
}

bool fit_side_by_side(const Category& a, const Category& b, const Category& support) {
  const auto room = room_of(support, Predicate::On);
  if (!room || std::max(a.size.z(), b.size.z()) + kMargin_m > room->clearance) return false;
  const auto as = std::minmax(a.size.x(), a.size.y()), bs = std::minmax(b.size.x(), b.size.y());
  const double narrow = std::min(room->width, room->depth), wide = std::max(room->width, room->depth);
  // In a row along the wide side: each with its short side along it when its long side still fits across.
  const auto along = [&](double small, double large) { return large + kMargin_m <= narrow ? small : large; };
  const double a_along = along(as.first, as.second), b_along = along(bs.first, bs.second);
  return as.first + kMargin_m <= narrow && bs.first + kMargin_m <= narrow && a_along + b_along + kApart_m <= wide;
}

bool usable(const Asset& asset, const Category& category) {
  const bool holds = room_of(category, Predicate::On) || room_of(category, Predicate::Inside);
  const auto close = [&](const Vec3& size) {
    const Vec3 ratio = size.cwiseQuotient(category.size);
    return ratio.minCoeff() >= (holds ? kSmallerHolder : kSmallerModel) && ratio.maxCoeff() <= kLargerModel;
  };
  const bool no_front = category.movable || category.archetype == Archetype::Table ||
                        category.archetype == Archetype::Plate || category.archetype == Archetype::Vessel ||
                        category.archetype == Archetype::Fixture;
  return close(asset.size) || (no_front && close({asset.size.y(), asset.size.x(), asset.size.z()}));
}

int capacity_of(const Category& object, Predicate relation, const Category& receptacle) {
  const auto room = room_of(receptacle, relation);
  if (!room || !fits(object.size, *room)) return 0;
  const auto count = [&](double w, double d) {
    return static_cast<int>(room->width / (w + kApart_m)) * static_cast<int>(room->depth / (d + kApart_m));
  };
  const int grid = std::max(count(object.size.x(), object.size.y()), count(object.size.y(), object.size.x()));
  return std::clamp(static_cast<int>(0.6 * grid * room->levels), 1, 12);
}

}  // namespace unietp
