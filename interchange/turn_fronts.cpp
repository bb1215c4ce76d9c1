#include <algorithm>
#include <array>
#include <numbers>

#include "interchange/boxes.h"
#include "interchange/category_names.h"
#include "interchange/draft.h"

namespace unietp {
namespace {

constexpr double kShut_m = 0.1;     // what stands nearer before a front shuts it
constexpr double kCovered = 0.5;    // if it covers at least this share of it
constexpr double kPartOf = 0.3;     // of its volume in another box: it is a part of that, as a drawer is of a dresser
constexpr double kUpright = 0.999;  // cosine of the tilt
constexpr double kThin_m = 0.001;   // a probe ahead of a front begins this far ahead

Vec3 shared(const Bounds& a, const Bounds& b) { return (a.high.cwiseMin(b.high) - a.low.cwiseMax(b.low)).cwiseMax(0); }

/// Opens at its front: with doors or a drawer, not with a lid.
bool has_front(const Node& node) {
  const bool kind = node.archetype == Archetype::Cabinet || node.archetype == Archetype::Drawers;
  return kind && !node.movable && node.openable && node.opening == 0 &&
         (node.pose.rotation * Vec3::UnitZ()).z() > kUpright;
}

Node turned(Node node, int quarters) {
  node.pose.rotation = node.pose.rotation * Quat(Eigen::AngleAxisd(quarters * std::numbers::pi / 2, Vec3::UnitZ()));
  if (quarters % 2 != 0) std::swap(node.size.x(), node.size.y());
  return node;
}

class Fronts {
 public:
  Fronts(const SourceScene& source, const FormatFacts& facts, const Draft& draft) : scene_(draft.scene) {
    for (const Node& node : scene_.nodes) boxes_.push_back(bounds_of(node.pose, node.size));
    for (const SourceObject& object : source.objects) {
      if (!object.category.starts_with("wall") || !is_of_the_building(object.category, facts)) continue;
      const Bounds box = bounds_of(object.pose, object.size);
      if (box.low.allFinite() && box.high.allFinite()) walls_.push_back(box);
    }
  }

  /// Something that never moves stands right before the front, or it looks out of every room.
  bool is_shut(std::size_t i, const Node& node) const {
    const Vec3 half = node.size / 2;
    const Bounds ahead = bounds_of(node.pose * Pose{Vec3(0, -half.y() - (kShut_m + kThin_m) / 2, 0), Quat::Identity()},
                                   Vec3(node.size.x(), kShut_m - kThin_m, node.size.z()));
    const Vec2 point = (node.pose * Vec3(0, -half.y() - kShut_m, 0)).head<2>();
    const auto holds_point = [&](const Room& room) { return contains(room.polygon, point); };
    if (std::none_of(scene_.rooms.begin(), scene_.rooms.end(), holds_point)) return true;
    const auto covers = [&](const Bounds& other) {
      const Vec3 common = shared(ahead, other), whole = ahead.high - ahead.low;
      // Along the way ahead it may be thin.
      return common.minCoeff() > 0 &&
             common.z() * common.head<2>().maxCoeff() > kCovered * whole.z() * whole.head<2>().maxCoeff();
    };
    const double volume = volume_of(boxes_[i]);
    for (std::size_t k = 0; k < boxes_.size(); ++k) {
      if (k == i || scene_.nodes[k].movable || shared(boxes_[k], boxes_[i]).prod() > kPartOf * volume) continue;
      if (covers(boxes_[k])) return true;
    }
    return std::any_of(walls_.begin(), walls_.end(), covers);
  }

 private:
  const Scene& scene_;
  std::vector<Bounds> boxes_, walls_;  // W
};

}  // namespace

void turn_fronts(const SourceScene& source, const FormatFacts& facts, Draft& draft) {
  const Fronts fronts(source, facts, draft);
  for (std::size_t i = 0; i < draft.scene.nodes.size(); ++i) {
    const Node& node = draft.scene.nodes[i];
    if (!has_front(node) || !fronts.is_shut(i, node)) continue;
    for (const int quarters : {2, 1, 3}) {
      Node other = turned(node, quarters);
      if (fronts.is_shut(i, other)) continue;
      const Vec3 moved = other.pose * Vec3(0, -other.size.y() / 2, 0) - node.pose * Vec3(0, -node.size.y() / 2, 0);
      draft.repairs.push_back({i, RepairKind::Turned, std::nullopt, moved.norm()});
      draft.center_in_node[i] = inverse(other.pose) * draft.file_center[i];
      draft.scene.nodes.edit(i) = std::move(other);
      break;
    }
  }
}

}  // namespace unietp
