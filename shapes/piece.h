#pragma once

#include <cstdint>
#include <optional>

#include "scene/geometry.h"
#include "shapes/matter.h"

namespace unietp {

/// The solids that shapes are made of. Each fills the cube from -1 to 1 of its own frame, or less of it by `low` and
/// `high`. All but the hollow ones are convex.
enum class PieceKind : std::uint8_t {
  Block,  // a box, narrowed toward an end along x and y
  Drum,   // an upright cylinder or cone
  Ball,
  Cup,    // a drum with a hollow that is open above
  Crate,  // a block with a hollow that is open above
};

/// One colored solid of an object, in the frame of the object's box: x to the right, y to the back, z up, from -1 to 1
/// each.
struct Piece {
  PieceKind kind = PieceKind::Block;
  Vec3 center = Vec3::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // columns: the half axes of its own frame
  Vec2 low = Vec2::Ones(), high = Vec2::Ones();        // half widths at z = -1 and z = 1, in (0, 1]
  double wall = 0.1, floor = 0.1;                      // of hollows: thickness in the piece's own frame
  std::optional<Rgb> color{};                          // its own; nullopt: that of the object
  double shade = 1;                                    // times the object's color, when it has none of its own
  std::optional<Matter> matter{};                      // nullopt: that of the object
  bool screen = false;                                 // shows a picture when the object is on
};

}  // namespace unietp
