#include "interchange/supports.h"

#include <algorithm>

#include "interchange/boxes.h"

namespace unietp {
namespace {

constexpr double kNear_m = 0.02;  // without a word in the file: what reaches this near stands there

}  // namespace

Supports::Supports(const Draft& draft, const std::vector<Bounds>& boxes)
    : holders_(boxes.size()), children_(boxes.size()) {
  for (const Bounds& box : boxes) volumes_.push_back(volume_of(box));
  std::vector<bool> is_given(boxes.size(), false);
  for (const DraftRelation& relation : draft.relations) {
    if (!relation.node) continue;
    const bool on_floor = !relation.held && boxes[*relation.node].low.z() < kOnFloor_m;
    if (relation.held || on_floor) is_given[*relation.node] = true;
    if (relation.held) holders_[*relation.node].push_back(*relation.held);
  }
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    auto& holders = holders_[i];
    std::stable_sort(holders.begin(), holders.end(), [&](std::size_t a, std::size_t b) { return smaller(a, b); });
    if (is_given[i] || !draft.scene.nodes[i].movable) continue;
    if (const auto holder = holder_by_place(draft, boxes, i)) holders.push_back(*holder);
  }
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (const std::size_t holder : holders_[i]) children_[holder].push_back(i);
    above_.push_back(all_above(i));
  }
}

bool Supports::held_by(std::size_t node, std::size_t holder) const {
  return std::binary_search(above_[node].begin(), above_[node].end(), holder);
}

bool Supports::smaller(std::size_t a, std::size_t b) const {
  return volumes_[a] != volumes_[b] ? volumes_[a] < volumes_[b] : a < b;
}

std::optional<std::size_t> Supports::holder_by_place(const Draft& draft, const std::vector<Bounds>& boxes,
                                                     std::size_t node) const {
  const Bounds& box = boxes[node];
  const Vec3 bottom((box.low.x() + box.high.x()) / 2, (box.low.y() + box.high.y()) / 2, box.low.z());
  if (bottom.z() < kNear_m) return std::nullopt;
  std::optional<std::size_t> best;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const Archetype kind = draft.scene.nodes[k].archetype;
    if (k == node || kind == Archetype::Panel || kind == Archetype::Fixture || !smaller(node, k)) continue;
    const Bounds reach = grown(boxes[k], 0, kNear_m);
    if ((bottom - reach.low).minCoeff() < 0 || (reach.high - bottom).minCoeff() < 0) continue;
    if (!best || smaller(k, *best)) best = k;
  }
  return best;
}

std::vector<std::size_t> Supports::all_above(std::size_t node) const {
  std::vector<bool> seen(holders_.size(), false);
  std::vector<std::size_t> open{node}, all;
  seen[node] = true;
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    for (const std::size_t holder : holders_[at]) {
      if (seen[holder]) continue;
      seen[holder] = true;
      open.push_back(holder);
      all.push_back(holder);
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace unietp
