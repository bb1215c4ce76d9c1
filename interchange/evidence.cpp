#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "interchange/boxes.h"
#include "interchange/draft.h"
#include "interchange/supports.h"
#include "simulation/shape.h"

namespace unietp {
namespace {

constexpr double kSameLevel_m = 0.012;  // bottoms that differ by less stand on one board
constexpr double kTouching_m = 0.001;   // boxes that overlap by less only touch
constexpr double kSupported_m = 0.002;
constexpr double kBoard_m = 0.02;
constexpr double kRise_m = 0.03;   // a surface is raised by this at most; what stands higher gets a board of its own
constexpr double kPad_m = 0.01;    // such a board reaches this far around what stands on it
constexpr double kEdge_m = 0.011;  // surfaces end this far from the edge of their solid
constexpr double kInner_m = 0.25;  // a shelf is moved by this at most
constexpr double kThickPanel_m = 0.4;
constexpr std::size_t kMostBoards = 400;

/// A child as its holder's frame sees it.
struct Standing {
  std::size_t node;
  Bounds box;  // frame of the holder
};

class Evidence {
 public:
  explicit Evidence(Draft& draft)
      : nodes_(draft.scene.nodes),
        boxes_(boxes_of(draft.scene.nodes)),
        holders_(draft, boxes_),
        heaped_(draft.heaped),
        repairs_(draft.repairs) {}

  void follow() {
    std::vector<std::size_t> order(nodes_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return holders_.above(a).size() < holders_.above(b).size(); });
    for (const std::size_t i : order) {
      if (!heaped_[i]) fit(i);
    }
  }

 private:
  static std::vector<Bounds> boxes_of(const SharedList<Node>& nodes) {
    std::vector<Bounds> boxes;
    for (const Node& node : nodes) boxes.push_back(box_of(node));
    return boxes;
  }

  Bounds seen_from(std::size_t f, std::size_t i) const {
    const Node& node = nodes_[i];
    return unietp::bounds_of(shapes(node), inverse(nodes_[f].pose) * node.pose, node.opening);
  }
  static Shape shapes(const Node& node) { return make_shape(node.archetype, node.size, node.openable); }

  void lower(std::size_t i, double by) {
    nodes_.edit(i).pose.position.z() -= by;
    boxes_[i].low.z() -= by;
    boxes_[i].high.z() -= by;
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      const bool stands_on_i = !holders_.of(k).empty() && holders_.of(k).front() == i;
      if (nodes_[k].movable && stands_on_i && holders_.above(k).size() > holders_.above(i).size()) lower(k, by);
    }
  }

  // The solids of one node.

  void fit(std::size_t f) {
    const Node& node = nodes_[f];
    const Shape shape = shapes(node);
    std::vector<Board> boards;
    for (const Part& part : shape.parts) boards.push_back({part.pose.position, part.size, part.joint});
    // A panel that is thick is a thin one in a box that goes around something else: it hangs at the back.
    bool changed = node.archetype == Archetype::Panel && node.size.y() > kThickPanel_m;
    if (changed) boards = {back_of(node)};
    if (const auto own = basin_in(f)) boards = around_hollow(f, *own), changed = true;
    if (is_a_basin_in_another(f)) {
      nodes_.edit(f).boards = {bottom_of(node)};
      return;
    }
    if (!node.movable) changed = give_way_to_furniture(f, boards) || changed;
    changed = fit_levels(f, shape, boards) || changed;
    std::vector<Board> pads = pads_for(f, boards);
    changed = changed || !pads.empty();
    boards.insert(boards.end(), pads.begin(), pads.end());
    changed = give_way_to_loose(f, boards) || changed;
    if (!changed) return;
    if (boards.empty() || boards.size() > kMostBoards) boards = {back_of(node)};
    nodes_.edit(f).boards = std::move(boards);
  }

  // Some files have the hollow of a sink or a tub as an object of its own, in a block that has the size of all. The
  // block gets the hollow, and of the other the bottom is left, as its drain.

  /// The smaller basin with its middle in basin f.
  std::optional<std::size_t> basin_in(std::size_t f) const {
    if (nodes_[f].archetype != Archetype::Basin || nodes_[f].movable) return std::nullopt;
    for (std::size_t g = 0; g < nodes_.size(); ++g) {
      const Vec3 from_middle = (boxes_[g].low + boxes_[g].high - boxes_[f].low - boxes_[f].high).cwiseAbs() / 2;
      const bool in_f = ((boxes_[f].high - boxes_[f].low) / 2 - from_middle).minCoeff() > 0;
      if (g != f && in_f && nodes_[g].archetype == Archetype::Basin && !nodes_[g].movable && holders_.smaller(g, f))
        return g;
    }
    return std::nullopt;
  }
  bool is_a_basin_in_another(std::size_t g) const {
    if (nodes_[g].archetype != Archetype::Basin) return false;
    for (std::size_t f = 0; f < nodes_.size(); ++f) {
      if (f != g && basin_in(f) == g) return true;
    }
    return false;
  }

  static Board bottom_of(const Node& node) {
    const Vec3 half = node.size / 2;
    return board_between(-half, {half.x(), half.y(), -half.z() + std::min(kPad_m, node.size.z())});
  }

  /// The block f with the hollow that basin g is in it.
  std::vector<Board> around_hollow(std::size_t f, std::size_t g) const {
    const Shape shape = shapes(nodes_[f]);
    const Cavity& cavity = shape.cavities.front();
    const Pose in_f = inverse(nodes_[f].pose) * nodes_[g].pose;
    Bounds hollow = unietp::bounds_of(in_f, nodes_[g].size);
    const double bottom = hollow.low.z();
    hollow.low.z() = bottom + 2 * kPad_m;
    hollow.low = hollow.low.cwiseMax(cavity.center - cavity.half);
    hollow.high = hollow.high.cwiseMin(cavity.center + cavity.half);
    hollow.high.z() = nodes_[f].size.z() / 2 + kTouching_m;
    const Vec3 half = nodes_[f].size / 2;
    std::vector<Board> boards{board_between(-half, half)};
    cut(boards, hollow);
    return boards;
  }

  static Board back_of(const Node& node) {
    const Vec3 half = node.size / 2;
    return board_between({-half.x(), half.y() - std::min(kBoard_m, half.y()), -half.z()}, half);
  }

  /// Cuts what node `other` takes up out of the boards of f.
  bool cut_for(std::size_t f, std::size_t other, std::vector<Board>& boards, const std::vector<Bounds>& holes) {
    bool any = false;
    double deepest = 0;
    for (const Bounds& hole : holes) {
      deepest = std::max(deepest, depth_in(boards, hole));
      any = cut(boards, hole) || any;
    }
    if (any) repairs_.push_back({f, RepairKind::Cut, other, deepest});
    return any;
  }

  /// Of two pieces of furniture that overlap the larger one gives way.
  bool give_way_to_furniture(std::size_t f, std::vector<Board>& boards) {
    bool any = false;
    for (std::size_t g = 0; g < nodes_.size() && boards.size() <= kMostBoards; ++g) {
      if (g == f || nodes_[g].movable || heaped_[g] || !overlap(boxes_[g], boxes_[f]) || !holders_.smaller(g, f))
        continue;
      std::vector<Bounds> holes = basin_in(f) == g ? drain(f, g) : hulls(f, g);
      for (Bounds& hole : holes) hole = grown(hole, -kTouching_m, -kTouching_m);
      any = cut_for(f, g, boards, holes) || any;
    }
    return any;
  }

  std::vector<Bounds> drain(std::size_t f, std::size_t g) const {
    const Board bottom = bottom_of(nodes_[g]);
    return {unietp::bounds_of(inverse(nodes_[f].pose) * nodes_[g].pose * Pose{bottom.center, Quat::Identity()},
                              bottom.size)};
  }

  /// What furniture g takes up in f's frame: its solids where one can see through it, else its whole box.
  std::vector<Bounds> hulls(std::size_t f, std::size_t g) const {
    const Node& node = nodes_[g];
    const Archetype kind = node.archetype;
    const bool airy =
        kind == Archetype::Table || kind == Archetype::Seat || kind == Archetype::Bed || kind == Archetype::Shelf;
    const Pose in_f = inverse(nodes_[f].pose) * node.pose;
    if (!airy) return {unietp::bounds_of(in_f, node.size)};
    std::vector<Bounds> all;
    for (const Part& part : shapes(node).parts) all.push_back(unietp::bounds_of(in_f * part.pose, part.size));
    return all;
  }

  /// Moves f's surfaces to the heights at which most things stand on them, and those things down onto them.
  bool fit_levels(std::size_t f, const Shape& shape, std::vector<Board>& boards) {
    std::vector<Standing> standing;
    for (const std::size_t child : holders_.children(f)) {
      if (nodes_[child].movable && holders_.of(child).front() == f) standing.push_back({child, seen_from(f, child)});
    }
    std::stable_sort(standing.begin(), standing.end(),
                     [](const Standing& a, const Standing& b) { return a.box.low.z() < b.box.low.z(); });
    std::vector<std::vector<Standing>> levels;
    for (const Standing& one : standing) {
      const bool same = !levels.empty() && one.box.low.z() - levels.back().front().box.low.z() < kSameLevel_m;
      if (!same) levels.emplace_back();
      levels.back().push_back(one);
    }
    std::stable_sort(levels.begin(), levels.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
    bool changed = false;
    std::vector<bool> taken(shape.surfaces.size(), false);
    for (const auto& level : levels) {
      const double z = level.front().box.low.z();
      for (const Standing& one : level) {
        lower(one.node, one.box.low.z() - z);
        repairs_.push_back({one.node, RepairKind::Lowered, f, one.box.low.z() - z});
      }
      const auto surface = surface_for(shape, level, taken);
      if (!surface) continue;
      taken[*surface] = true;
      if (!move_surface(f, shape.surfaces[*surface], z, boards)) continue;
      changed = true;
      repairs_.push_back(
          {f, RepairKind::Surface, level.front().node, std::abs(z - shape.surfaces[*surface].center.z())});
    }
    return changed;
  }

  std::optional<std::size_t> surface_for(const Shape& shape, const std::vector<Standing>& level,
                                         const std::vector<bool>& taken) const {
    const double z = level.front().box.low.z();
    std::optional<std::size_t> best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t s = 0; s < shape.surfaces.size(); ++s) {
      const Surface& surface = shape.surfaces[s];
      const double rise = z - surface.center.z();
      const bool top = surface.cavity < 0 && surface.clearance > 1;
      if (taken[s] || rise > kRise_m || (!top && rise < -kInner_m)) continue;
      const bool over = std::any_of(level.begin(), level.end(), [&](const Standing& one) {
        const Vec2 middle = ((one.box.low + one.box.high) / 2 - surface.center).head<2>().cwiseAbs();
        return (middle - surface.half).maxCoeff() < 0;
      });
      if (over && std::abs(rise) < least) best = s, least = std::abs(rise);
    }
    return best;
  }

  bool move_surface(std::size_t f, const Surface& surface, double z, std::vector<Board>& boards) const {
    const double rise = z - surface.center.z();
    if (std::abs(rise) < kTouching_m) return false;
    const bool top = surface.cavity < 0 && surface.clearance > 1;
    const double edge = top ? kEdge_m : 0.0;
    const Vec3 reach(surface.half.x() + edge, surface.half.y() + edge, 0);
    const Vec3 low = surface.center - reach, high = surface.center + reach;
    if (rise > 0) {
      boards.push_back(board_between(low, Vec3(high.x(), high.y(), z), surface.joint));
      return true;
    }
    cut_above(boards, surface.joint, {Vec3(low.x(), low.y(), z), high + Vec3(0, 0, kTouching_m)});
    const bool solid_below = std::any_of(boards.begin(), boards.end(), [&](const Board& board) {
      const Bounds box = unietp::bounds_of(board);
      return board.joint == surface.joint && std::abs(box.high.z() - z) < kTouching_m &&
             (box.high - box.low).head<2>().minCoeff() > surface.half.minCoeff();
    });
    if (solid_below) return true;
    const double bottom = lowest_board(f, z);
    if (z - bottom > kTouching_m)
      boards.push_back(board_between(Vec3(low.x(), low.y(), bottom), Vec3(high.x(), high.y(), z), surface.joint));
    return true;
  }

  static void cut_above(std::vector<Board>& boards, int joint, const Bounds& hole) {
    std::vector<Board> moving;
    std::vector<Board> others;
    for (const Board& board : boards) (board.joint == joint ? moving : others).push_back(board);
    cut(moving, hole);
    others.insert(others.end(), moving.begin(), moving.end());
    boards = std::move(others);
  }

  /// Where a board whose upper face is at z begins: furniture may reach below its box, what moves may not.
  double lowest_board(std::size_t f, double z) const {
    const double thin = z - kBoard_m;
    return nodes_[f].movable ? std::max(thin, -nodes_[f].size.z() / 2) : thin;
  }

  /// Boards under what stands where f has no solid.
  std::vector<Board> pads_for(std::size_t f, const std::vector<Board>& boards) {
    std::vector<Board> pads;
    for (const std::size_t child : holders_.children(f)) {
      if (!nodes_[child].movable) continue;
      const Bounds box = seen_from(f, child);
      const double z = box.low.z(), bottom = lowest_board(f, z);
      if (z - bottom < kTouching_m || supported(boards, box)) continue;
      pads.push_back(board_between(Vec3(box.low.x() - kPad_m, box.low.y() - kPad_m, bottom),
                                   Vec3(box.high.x() + kPad_m, box.high.y() + kPad_m, z), moves_with(f, box)));
      repairs_.push_back({f, RepairKind::Board, child, air_below(boards, box, -nodes_[f].size.z() / 2)});
    }
    return pads;
  }

  /// The joint of the drawer that the box lies in, else -1.
  int moves_with(std::size_t f, const Bounds& box) const {
    const Vec3 middle = (box.low + box.high) / 2;
    for (const Cavity& cavity : shapes(nodes_[f]).cavities) {
      if (cavity.joint >= 0 && ((middle - cavity.center).cwiseAbs() - cavity.half).maxCoeff() < 0) return cavity.joint;
    }
    return -1;
  }

  /// From the middle of the box's underside down to the next board, else to `bottom`.
  static double air_below(const std::vector<Board>& boards, const Bounds& box, double bottom) {
    const Vec2 middle = ((box.low + box.high) / 2).head<2>();
    double below = bottom;
    for (const Board& board : boards) {
      const Bounds solid = unietp::bounds_of(board);
      const bool under = ((middle - solid.low.head<2>()).array() > 0).all() &&
                         ((solid.high.head<2>() - middle).array() > 0).all() &&
                         solid.high.z() <= box.low.z() + kSupported_m;
      if (under) below = std::max(below, solid.high.z());
    }
    return std::max(0.0, box.low.z() - below);
  }

  /// At least two thirds of the box's footprint have a board right below.
  static bool supported(const std::vector<Board>& boards, const Bounds& box) {
    double covered = 0;
    for (const Board& board : boards) {
      const Bounds solid = unietp::bounds_of(board);
      if (std::abs(solid.high.z() - box.low.z()) > kSupported_m) continue;
      const Vec2 shared = (solid.high.cwiseMin(box.high) - solid.low.cwiseMax(box.low)).head<2>().cwiseMax(0.0);
      covered += shared.prod();
    }
    return covered > 0.67 * (box.high - box.low).head<2>().prod();
  }

  /// Cuts away what would overlap things that move; of two such things the larger gives way, and what holds always
  /// gives way to what it holds.
  bool give_way_to_loose(std::size_t f, std::vector<Board>& boards) {
    bool any = false;
    const Bounds around = grown(boxes_[f], 0.05, 0.05);
    for (std::size_t m = 0; m < nodes_.size() && boards.size() <= kMostBoards; ++m) {
      if (m == f || !nodes_[m].movable || !overlap(boxes_[m], around)) continue;
      if (nodes_[f].movable && (holders_.held_by(f, m) || (!holders_.held_by(m, f) && holders_.smaller(f, m))))
        continue;
      Bounds hole = seen_from(f, m);
      hole.low.z() += kTouching_m / 2;
      any = cut_for(f, m, boards, {hole}) || any;
    }
    return any;
  }

  SharedList<Node>& nodes_;
  std::vector<Bounds> boxes_;  // W, as the joints stand
  Supports holders_;
  const std::vector<bool>& heaped_;
  std::vector<DraftRepair>& repairs_;
};

}  // namespace

void follow_evidence(Draft& draft) { Evidence(draft).follow(); }

}  // namespace unietp
