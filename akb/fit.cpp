#include "akb/fit.h"

#include <algorithm>
#include <cmath>

namespace unietp {
namespace {

constexpr double kOpen_m = 3;           // free height where there is no roof but the ceiling
constexpr double kShelf_m = 0.36;       // usual distance of shelves
constexpr double kHighestTop_m = 1.25;  // a higher top is out of reach
constexpr double kMargin_m = 0.01;

/// Thickness of a wall: 2 cm for furniture, a tenth of the smaller side for small things.
double wall(const Vec3& size) { return std::clamp(0.1 * std::min(size.x(), size.y()), 0.004, 0.02); }

int shelves(double height) { return std::max(1, static_cast<int>(std::lround(height / kShelf_m))); }

std::optional<Room3> hollow(const Category& c) {
  const double t = wall(c.size);
  const Vec3& s = c.size;
  switch (c.archetype) {
    case Archetype::Cabinet: {
      const double height = s.z() - 2 * t;
      const int levels = height > 0.55 ? shelves(height) : 1;
      return Room3{s.x() - 2 * t, s.y() - 2 * t, height / levels - (levels > 1 ? t : 0), false, levels};
    }
    case Archetype::Drawers:
      return Room3{s.x() - 4 * t, s.y() - 4 * t, std::min(0.2, s.z() / 3) - 2 * t, false, 1};
    case Archetype::Basin:
      return Room3{0.8 * s.x() - 2 * t, 0.8 * s.y() - 2 * t, std::min(0.18, 0.7 * s.z()), true, 1};
    case Archetype::Vessel:
      return Room3{s.x() - 2 * t, s.y() - 2 * t, s.z() - t, true, 1};
    case Archetype::Lidded:
      return Room3{s.x() - 2 * t, s.y() - 2 * t, s.z() - 2.5 * t, false, 1};
    default:
      return std::nullopt;
  }
}

std::optional<Room3> top(const Category& c) {
  const double t = wall(c.size);
  const Vec3& s = c.size;
  switch (c.archetype) {
    case Archetype::Block:
    case Archetype::Table:
    case Archetype::Drawers:
      return Room3{s.x(), s.y(), kOpen_m, false, 1};
    case Archetype::Cabinet:
      if (s.z() > kHighestTop_m) return std::nullopt;
      return Room3{s.x(), s.y(), kOpen_m, false, 1};
    case Archetype::Seat:
      return Room3{0.9 * s.x(), 0.65 * s.y(), kOpen_m, false, 1};
    case Archetype::Bed:
      return Room3{s.x(), 0.85 * s.y(), kOpen_m, false, 1};
    case Archetype::Shelf: {
      const int levels = shelves(s.z());
      return Room3{s.x() - 2 * t, s.y() - t, s.z() / levels - 2 * t, false, levels};
    }
    case Archetype::Plate:
      return Room3{0.95 * s.x(), 0.95 * s.y(), kOpen_m, false, 1};
    case Archetype::Fixture:
      return Room3{s.x(), s.y(), kOpen_m, false, 1};
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<Room3> room_of(const Category& receptacle, std::string_view relation) {
  if (relation == "inside") return hollow(receptacle);
  if (relation == "on") return top(receptacle);
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

int capacity_of(const Category& object, std::string_view relation, const Category& receptacle) {
  const auto room = room_of(receptacle, relation);
  if (!room || !fits(object.size, *room)) return 0;
  const auto count = [&](double w, double d) {
    return static_cast<int>(room->width / (w + 0.02)) * static_cast<int>(room->depth / (d + 0.02));
  };
  const int grid = std::max(count(object.size.x(), object.size.y()), count(object.size.y(), object.size.x()));
  return std::clamp(static_cast<int>(0.6 * grid * room->levels), 1, 12);
}

}  // namespace unietp
