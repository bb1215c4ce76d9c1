#pragma once

#include <vector>

#include "scene/geometry.h"
#include "scene/scene.h"

namespace unietp {

// Sums and differences of upright boxes in one frame.

/// The board between two corners; it moves with the joint, -1 for none.
Board board_between(const Vec3& low, const Vec3& high, int joint = -1);
/// The corners of a board.
Bounds bounds_of(const Board& board);

/// What is left of the boards outside of `hole`, as boards again; pieces thinner than 3 mm are dropped. Boards that the
/// hole does not touch stay as they are. True when anything was cut.
bool cut(std::vector<Board>& boards, const Bounds& hole);

/// How deep the hole is in one of the boards, the most of all; 0 when it is in none.
double depth_in(const std::vector<Board>& boards, const Bounds& hole);

/// The bounds grown (or shrunk) sideways and in height.
Bounds grown(const Bounds& bounds, double sideways, double height);

/// Cubic meters.
double volume_of(const Bounds& bounds);

}  // namespace unietp
