#pragma once

#include <cstdint>
#include <optional>

#include "shapes/matter.h"
#include "simulation/shape.h"

namespace unietp {

/// What a solid shows besides its object's body; pictures alone have the others.
enum class Skin : std::uint8_t { Body, Liquid, Water, Flame, Cord, Plug, Socket, Flap, Mouth };

/// Those of physics, and those of shapes alone. All but cups and crates, which are hollow above, are convex.
enum class SolidKind : std::uint8_t { Box, Cylinder, Sphere, Wedge, Cone, Cup, Crate };

/// The solid of a part of physics.
inline SolidKind kind_of(Part::Kind kind) {
  return kind == Part::Kind::Box        ? SolidKind::Box
         : kind == Part::Kind::Cylinder ? SolidKind::Cylinder
                                        : SolidKind::Sphere;
}

/// A solid in W.
struct Solid {
  SolidKind kind = SolidKind::Box;
  Pose pose;
  Vec3 size = Vec3::Zero();  // full extents, meters
  std::int32_t owner = -1;   // position in Scene::nodes; negative for walls
  bool moves = false;        // a door, lid or drawer
  Skin skin = Skin::Body;

  // Of the pieces of shapes (shapes/piece.h). Their own frame is the cube from -1 to 1, and need not be a rotated one.
  bool sheared = false;                                // `axes` and the position place it; rotation and size do not
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // columns: the half axes of its own frame, W
  Vec2 low = Vec2::Ones(), high = Vec2::Ones();        // half widths at its lower and upper end
  double wall = 0, floor = 0;                          // of hollows, in its own frame
  std::optional<Rgb> color{};                          // its own; nullopt: the object's, times `shade`
  double shade = 1;
  std::optional<Matter> matter{};  // nullopt: the object's
  double handle = 0;               // of doors and drawers: 1 or -1: on the right or left side; 2: across
  bool screen = false;             // shows a picture when the object is on
  bool clear = false;              // what is behind it is seen through it
};

}  // namespace unietp
