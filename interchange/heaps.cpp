#include <algorithm>
#include <set>
#include <utility>

#include "interchange/boxes.h"
#include "interchange/draft.h"

namespace unietp {
namespace {

constexpr double kInside_m = 0.01;           // boxes that overlap by less may only lean on one another
constexpr std::size_t kMostInOneThing = 12;  // real homes have clothes on a rail and bowls in a stack, of up to ten

/// The movable things in whose boxes a thing's box is, of each node; in no order.
class Overlaps {
 public:
  explicit Overlaps(const Draft& draft) : others_(draft.scene.nodes.size()) {
    for (const DraftRelation& relation : draft.relations) {
      if (relation.node && relation.held) holding_.insert(std::minmax(*relation.node, *relation.held));
    }
    const auto& nodes = draft.scene.nodes;
    std::vector<Bounds> boxes;
    for (const Node& node : nodes) boxes.push_back(grown(box_of(node), -kInside_m / 2, -kInside_m / 2));
    std::vector<std::size_t> along;  // the movable ones, from where they begin in x
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (nodes[i].movable) along.push_back(i);
    }
    std::sort(along.begin(), along.end(), [&](std::size_t a, std::size_t b) {
      return std::pair(boxes[a].low.x(), a) < std::pair(boxes[b].low.x(), b);
    });
    for (std::size_t first = 0; first < along.size(); ++first) {
      const std::size_t a = along[first];
      for (std::size_t next = first + 1; next < along.size(); ++next) {
        const std::size_t b = along[next];
        if (boxes[b].low.x() >= boxes[a].high.x()) break;
        if (!overlap(boxes[a], boxes[b]) || holding_.contains(std::minmax(a, b))) continue;
        others_[a].push_back(b);
        others_[b].push_back(a);
      }
    }
  }

  const std::vector<std::size_t>& of(std::size_t node) const { return others_[node]; }

 private:
  std::set<std::pair<std::size_t, std::size_t>> holding_;  // one is on or in the other by the file's own word
  std::vector<std::vector<std::size_t>> others_;
};

}  // namespace

void fix_heaps(const SourceScene& source, Draft& draft) {
  const std::size_t count = draft.scene.nodes.size();
  draft.heaped.assign(count, false);
  const Overlaps overlaps(draft);
  std::vector<std::size_t> open;
  const auto add = [&](std::size_t node) {
    if (draft.heaped[node]) return;
    draft.heaped[node] = true;
    open.push_back(node);
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (overlaps.of(i).size() > kMostInOneThing) add(i);
  }
  while (!open.empty()) {  // what reaches into a heap is part of it
    const std::size_t node = open.back();
    open.pop_back();
    for (const std::size_t other : overlaps.of(node)) add(other);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!draft.heaped[i]) continue;
    draft.scene.nodes.edit(i).movable = false;
    const SourceObject& object = source.objects[draft.source_of[i]];
    draft.report.issues.push_back({object.id, object.category, ImportReason::Restless,
                                   "cannot be moved: it is part of a heap of things that are inside one another (" +
                                       std::to_string(overlaps.of(i).size()) +
                                       " in its own box) and is fixed in place"});
  }
}

}  // namespace unietp
