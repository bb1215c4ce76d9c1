#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/text.h"
#include "interchange/boxes.h"
#include "interchange/category_names.h"
#include "interchange/draft.h"

namespace unietp {
namespace {

/// Chains of `on` and `inside` of a scene.
class Holding {
 public:
  explicit Holding(const Scene& scene) {
    for (const Edge& edge : scene.edges) {
      if (edge.relation == Predicate::On || edge.relation == Predicate::Inside) holders_[edge.from].push_back(&edge);
      if (edge.relation == Predicate::OnFloor) on_floor_.insert(edge.from);
    }
  }

  bool on_floor(const std::string& id) const { return on_floor_.contains(id); }

  /// `receptacle` holds `id`, perhaps through others, in a chain that ends with a relation of this kind.
  bool holds(const std::string& receptacle, const std::string& id, SourceRelation::Kind kind) const {
    std::set<std::string> seen{id};
    std::vector<std::string> open{id};
    while (!open.empty()) {
      const auto edges = holders_.find(open.back());
      open.pop_back();
      if (edges == holders_.end()) continue;
      for (const Edge* edge : edges->second) {
        const bool inside = edge->relation == Predicate::Inside;
        const bool fits = kind == SourceRelation::Kind::OnOrInside || inside == (kind == SourceRelation::Kind::Inside);
        if (edge->to == receptacle && fits) return true;
        if (seen.insert(edge->to).second) open.push_back(edge->to);
      }
    }
    return false;
  }

 private:
  std::map<std::string, std::vector<const Edge*>> holders_;
  std::set<std::string> on_floor_;
};

/// How far a node stands from where the file has it, meters.
double off_by(const Draft& draft, std::size_t node) {
  return (draft.scene.nodes[node].pose * draft.center_in_node[node] - draft.file_center[node]).norm();
}

std::string millimeters(double meters) {
  return meters < 1000 ? std::to_string(std::lround(meters * 1000)) + " mm" : "more than a kilometer";
}

/// Floors, walls and doors are there when some room's outline, wall or opening is.
bool drawn(const SourceObject& object, const Scene& scene) {
  const Bounds box = grown(bounds_of(object.pose, object.size), 0.3, 0);
  return std::any_of(scene.rooms.begin(), scene.rooms.end(), [&](const Room& room) {
    if (contains(room.polygon, object.pose.position.head<2>())) return true;
    return std::any_of(room.polygon.begin(), room.polygon.end(), [&](const Vec2& corner) {
      return (corner - box.low.head<2>()).minCoeff() > 0 && (box.high.head<2>() - corner).minCoeff() > 0;
    });
  });
}

}  // namespace

int count_in_place(const SourceScene& source, Draft& draft, bool list) {
  int near = 0;
  for (const std::size_t i : draft.structure) near += drawn(source.objects[i], draft.scene);
  for (std::size_t i = 0; i < draft.scene.nodes.size(); ++i) {
    const double off = off_by(draft, i);
    if (off < kArrived_m) {
      ++near;
    } else if (list) {
      const SourceObject& object = source.objects[draft.source_of[i]];
      draft.report.issues.push_back(
          {object.id, object.category, ImportReason::Moved, millimeters(off) + " from the file's pose"});
    }
  }
  return near;
}

void report_repairs(const SourceScene& source, Draft& draft) {
  constexpr double kLeast_m = 0.001;  // physics lets resting bodies sink into one another by less
  std::stable_sort(draft.repairs.begin(), draft.repairs.end(),
                   [](const DraftRepair& a, const DraftRepair& b) { return a.node < b.node; });
  for (const DraftRepair& repair : draft.repairs) {
    if (repair.by_m < kLeast_m) continue;
    const SourceObject& object = source.objects[draft.source_of[repair.node]];
    draft.report.repairs.push_back({object.id, object.category, draft.scene.nodes[repair.node].id, repair.kind,
                                    repair.other ? source.objects[draft.source_of[*repair.other]].id : "",
                                    repair.by_m});
  }
}

void compare_relations(const SourceScene& source, const FormatFacts& facts, Draft& draft) {
  const Holding holding(draft.scene);
  for (const DraftRelation& relation : draft.relations) {
    ++draft.report.relations;
    const SourceObject& object = source.objects[relation.object];
    const SourceObject& receptacle = source.objects[relation.receptacle];
    const bool moves = relation.node && draft.scene.nodes[*relation.node].movable;
    const bool placed = relation.node || is_of_the_building(object.category, facts);
    const bool receptacle_placed = relation.held || is_of_the_building(receptacle.category, facts);
    bool held = false;
    if (!placed || !receptacle_placed) {
      held = false;
    } else if (!moves) {
      held = true;  // furniture stands as the file has it, at its place beside the other's
    } else if (!relation.held) {
      const Node& node = draft.scene.nodes[*relation.node];
      // Some files say "on the floor" of what stands on furniture: then that it still stands there.
      const double height = bounds_of(object.pose, object.size).low.z();
      held = holding.on_floor(node.id) || (height > kOnFloor_m && off_by(draft, *relation.node) < kArrived_m);
    } else {
      held = holding.holds(draft.scene.nodes[*relation.held].id, draft.scene.nodes[*relation.node].id, relation.kind);
    }
    draft.report.relations_held += held;
    draft.report.loose += moves;
    draft.report.loose_held += moves && held;
    if (held) continue;
    draft.report.issues.push_back(
        {object.id, object.category, ImportReason::RelationLost, "no longer on or in " + receptacle.id});
  }
}

}  // namespace unietp
