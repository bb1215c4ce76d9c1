#include <algorithm>
#include <cmath>

#include "interchange/boxes.h"
#include "interchange/draft.h"
#include "simulation/shape.h"

namespace unietp {
namespace {

constexpr int kSteps = 8;            // of a door's way that are looked at
constexpr double kPiece_m = 0.05;    // a door is looked at in pieces of this width, since it turns
constexpr double kScrape_m = 0.002;  // less than what a door may scrape over on its way
constexpr double kRoom_m = 0.002;    // left between a door and what was cut for it
constexpr double kMostCut_m = 0.1;   // what is in the way by more stays
constexpr std::size_t kMostBoards = 400;

/// The pieces of a node's doors and drawers as they are on their way, in the frame of another.
std::vector<Bounds> way_of(const Node& node, const Shape& shape, const Pose& frame) {
  std::vector<Bounds> way;
  const Pose in_frame = inverse(frame) * node.pose;
  for (const Part& part : shape.parts) {
    if (part.joint < 0) continue;
    const auto pieces = static_cast<int>(std::ceil(part.size.x() / kPiece_m));
    const double width = part.size.x() / pieces;
    for (int step = 1; step <= kSteps; ++step) {
      const Pose at = in_frame * joint_motion(shape, part.joint, static_cast<double>(step) / kSteps) * part.pose;
      for (int k = 0; k < pieces; ++k) {
        const Pose middle = at * Pose{Vec3(-part.size.x() / 2 + (k + 0.5) * width, 0, 0), Quat::Identity()};
        way.push_back(bounds_of(middle, Vec3(width, part.size.y(), part.size.z())));
      }
    }
  }
  return way;
}

std::vector<Board> boards_of(const Node& node) {
  std::vector<Board> boards;
  for (const Part& part : shape_of(node).parts) boards.push_back({part.pose.position, part.size, part.joint});
  return boards;
}

/// Cuts out of a node what the pieces pass through; how much is in the way, where that is little; 0 when nothing was.
double cut_for(const std::vector<Bounds>& way, Node& node) {
  std::vector<Board> boards = boards_of(node);
  std::vector<Bounds> holes;
  Bounds all;
  for (const Bounds& piece : way) {
    const Bounds inner = grown(piece, -kScrape_m, -kScrape_m);
    if ((inner.high - inner.low).minCoeff() <= 0) continue;
    for (const Board& board : boards) {
      const Bounds solid = bounds_of(board);
      if (!overlap(solid, inner)) continue;
      const Bounds met{solid.low.cwiseMax(piece.low), solid.high.cwiseMin(piece.high)};
      all = holes.empty() ? met : Bounds{all.low.cwiseMin(met.low), all.high.cwiseMax(met.high)};
      holes.push_back(grown(piece, kRoom_m, kRoom_m));
      break;
    }
  }
  if (holes.empty()) return 0;
  const double deep = (all.high - all.low).minCoeff();
  if (deep > kMostCut_m) return 0;
  for (const Bounds& hole : holes) {
    cut(boards, hole);
    if (boards.empty() || boards.size() > kMostBoards) return 0;
  }
  node.boards = std::move(boards);
  return deep;
}

}  // namespace

void clear_doors(Draft& draft) {
  auto& nodes = draft.scene.nodes;
  std::vector<Bounds> boxes;
  for (const Node& node : nodes) boxes.push_back(box_of(node));
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node opens = nodes[i];
    const Shape shape = shape_of(opens);
    if (opens.movable || !opens.openable || opens.opening > 0 || shape.joints.empty() || draft.heaped[i]) continue;
    Bounds swept = boxes[i];
    for (const Bounds& piece : way_of(opens, shape, Pose{}))
      swept = {swept.low.cwiseMin(piece.low), swept.high.cwiseMax(piece.high)};
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      if (k == i || nodes[k].movable || draft.heaped[k] || !overlap(boxes[k], swept)) continue;
      Node other = nodes[k];
      const double deep = cut_for(way_of(opens, shape, other.pose), other);
      if (deep <= 0) continue;
      draft.repairs.push_back({k, RepairKind::Cut, i, deep});
      nodes.edit(k) = std::move(other);
    }
  }
}

}  // namespace unietp
