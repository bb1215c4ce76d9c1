#include "interchange/boxes.h"

#include <algorithm>

namespace unietp {
namespace {

constexpr double kThinnest_m = 0.003;

void keep(std::vector<Board>& pieces, const Vec3& low, const Vec3& high, int joint) {
  if ((high - low).minCoeff() >= kThinnest_m) pieces.push_back(board_between(low, high, joint));
}

}  // namespace

Board board_between(const Vec3& low, const Vec3& high, int joint) { return {(low + high) / 2, high - low, joint}; }

Bounds bounds_of(const Board& board) { return {board.center - board.size / 2, board.center + board.size / 2}; }

bool cut(std::vector<Board>& boards, const Bounds& hole) {
  std::vector<Board> left;
  bool any = false;
  for (const Board& board : boards) {
    Bounds rest = bounds_of(board);
    if (!overlap(rest, hole)) {
      left.push_back(board);
      continue;
    }
    any = true;
    // Height first: what is left below the hole stays one broad board.
    for (const int axis : {2, 0, 1}) {
      Vec3 high = rest.high, low = rest.low;
      high[axis] = hole.low[axis];
      keep(left, rest.low, high, board.joint);
      low[axis] = hole.high[axis];
      keep(left, low, rest.high, board.joint);
      rest.low[axis] = std::max(rest.low[axis], hole.low[axis]);
      rest.high[axis] = std::min(rest.high[axis], hole.high[axis]);
    }
  }
  boards = std::move(left);
  return any;
}

double depth_in(const std::vector<Board>& boards, const Bounds& hole) {
  double deepest = 0;
  for (const Board& board : boards) {
    const Bounds solid = bounds_of(board);
    const Vec3 out_up = solid.high - hole.low, out_down = hole.high - solid.low;  // ways out of the board
    deepest = std::max(deepest, std::min(out_up.minCoeff(), out_down.minCoeff()));
  }
  return deepest;
}

Bounds grown(const Bounds& bounds, double sideways, double height) {
  const Vec3 by(sideways, sideways, height);
  return {bounds.low - by, bounds.high + by};
}

double volume_of(const Bounds& bounds) { return (bounds.high - bounds.low).cwiseMax(0.0).prod(); }

}  // namespace unietp
