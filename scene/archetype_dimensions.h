#pragma once

#include "scene/geometry.h"

namespace unietp {

// The dimensions of the parts of each archetype (scene/archetype.h), from the full extents of an object: meters,
// width x, depth y, height z. simulation/shape builds solids of them, akb/fit works out what there is room for.

inline constexpr double kOpenAbove_m = 2.0;     // clearance of a surface with nothing over it
inline constexpr double kSurfaceEdge_m = 0.01;  // things are not set down nearer than this to an edge
inline constexpr double kDoorGap_m = 0.002;     // between a door, lid or drawer and its frame
// What akb/fit keeps free on top: of a cabinet's depth for its doors, and of a seat's in front of the backrest. The
// doors that physics builds are as thick as the walls with a gap behind them (CabinetDimensions), 3 mm less on all but
// small ones. The allowance stays as it is, since what fits on what would change, and with it the knowledge tables and
// the published benchmark that is generated from them.
inline constexpr double kDoorAllowance_m = 0.025;
inline constexpr double kBackrestGap_m = 0.01;
inline constexpr double kLidTravel_rad = 1.9;  // leans back past upright

/// A top on four legs.
struct TableDimensions {
  double top = 0, leg = 0;  // thickness of the top, side of a leg
};
TableDimensions table_dimensions(const Vec3& size);

/// A seat slab with a backrest behind it.
struct SeatDimensions {
  double back = 0;  // thickness of the backrest; the seat is half as high as it
};
SeatDimensions seat_dimensions(const Vec3& size);

/// A mattress on legs against a headboard.
struct BedDimensions {
  double headboard = 0, height = 0;  // thickness of the headboard; of the mattress's upper face
  double gap = 0, leg = 0;           // free height under the mattress, side of a leg
};
BedDimensions bed_dimensions(const Vec3& size);

/// Boards between two sides and a back.
struct ShelfDimensions {
  int bays = 0;      // spaces between boards; 0: too low for sides, a single board on a wall
  double board = 0;  // thickness of boards, sides and back
  double pitch = 0;  // from board to board
};
ShelfDimensions shelf_dimensions(const Vec3& size);

/// A hollow body with shelves inside and a door in front.
struct CabinetDimensions {
  double wall = 0;      // thickness of the walls, shelves and doors
  int bays = 1;         // spaces between shelves
  double pitch = 0;     // from shelf to shelf
  double set_back = 0;  // how far shelves end behind the doors
};
CabinetDimensions cabinet_dimensions(const Vec3& size);

/// A chest: its top drawer slides, what is below is solid.
struct DrawersDimensions {
  double wall = 0, slot = 0;  // thickness of walls and of the drawer; height of the drawer's slot
};
DrawersDimensions drawers_dimensions(const Vec3& size);

/// A block with a hollow that is open above: sinks are shallow, tubs deeper.
struct BasinDimensions {
  double wall = 0, depth = 0;
};
BasinDimensions basin_dimensions(const Vec3& size);

/// Thickness of the walls, the floor and the lid of a vessel or lidded box.
double vessel_wall(const Vec3& size);

}  // namespace unietp
