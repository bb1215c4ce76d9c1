#include "grounding/nearness_on_foot.h"

#include <algorithm>
#include <string>
#include <vector>

#include "grounding/goal_places.h"
#include "logic/evaluate.h"
#include "scene/geometry.h"
#include "scene/size_and_nearness.h"

namespace unietp {
namespace {

using Op = Formula::Op;

/// Whether a test says "the nearest to some ?b".
bool asks_for_nearest(const Formula& test, const std::string& variable) {
  return test.op == Op::Exists && test.children.front() == atom(Predicate::Nearest, {variable, test.variable});
}

class Pedestrian {
 public:
  Pedestrian(const Scene& scene, const NodeIndex& places, const Trace& trace, const NavigationGrid& grid)
      : scene_(scene), places_(places), trace_(trace), grid_(grid) {}

  /// Whether a thing is not clearly the nearest to a landmark of the others in the landmark's room.
  bool doubts(EntityIndex thing, EntityIndex landmark, const std::vector<EntityIndex>& others) const {
    const Room* room = room_of(landmark);
    const auto way = room == nullptr ? std::nullopt : meters(*room, landmark, thing);
    if (!way) return true;
    return std::any_of(others.begin(), others.end(), [&](EntityIndex other) {
      if (room_of(other) != room) return false;
      const auto other_way = meters(*room, landmark, other);
      return other_way && !clearly_nearer(*way, *other_way);
    });
  }

 private:
  const Room* room_of(EntityIndex thing) const {
    const auto here = std::find_if(scene_.rooms.begin(), scene_.rooms.end(), [&](const Room& room) {
      return trace_.states.front().any_related(Predicate::InRoom, thing,
                                               [&](EntityIndex one) { return trace_.entities[one].id == room.id; });
    });
    return here == scene_.rooms.end() ? nullptr : &*here;
  }
  std::optional<double> meters(const Room& room, EntityIndex from, EntityIndex to) const {
    const auto a = places_.find(trace_.entities[from].id), b = places_.find(trace_.entities[to].id);
    if (!a || !b) return std::nullopt;
    return on_foot(grid_, room, scene_.nodes[*a].pose.position.head<2>(), scene_.nodes[*b].pose.position.head<2>());
  }

  const Scene& scene_;
  const NodeIndex& places_;
  const Trace& trace_;
  const NavigationGrid& grid_;
};

}  // namespace

std::optional<double> on_foot(const NavigationGrid& grid, const Room& room, const Vec2& from, const Vec2& to) {
  const auto first = grid.nearest_free(from), last = grid.nearest_free(to);
  if (!first || !last) return std::nullopt;
  const auto cells = grid.path(*first, *last);
  if (cells.empty() || !std::all_of(cells.begin(), cells.end(), [&](NavigationGrid::Cell cell) {
        return contains(room.polygon, grid.centre(cell));
      }))
    return std::nullopt;
  double meters = (grid.centre(*first) - from).norm() + (grid.centre(*last) - to).norm();
  const auto corners = grid.walk(grid.centre(*first), grid.centre(*last));
  for (std::size_t i = 1; i < corners.size(); ++i) meters += (corners[i] - corners[i - 1]).norm();
  return meters;
}

std::optional<GroundingFailure> check_nearness_on_foot(const Formula& goal, const Scene& scene, const NodeIndex& places,
                                                       const Trace& trace, const NavigationGrid& grid) {
  const Pedestrian pedestrian(scene, places, trace, grid);
  for (const auto& [domain, referents, others] : referred_things(goal, trace)) {
    const Formula& where = domain.domain.where.front();
    const auto tests = where.op == Op::And ? where.children : std::vector<Formula>{where};
    for (const Formula& test : tests) {
      if (!asks_for_nearest(test, domain.variable)) continue;
      for (const EntityIndex landmark : members_of(test.domain, test.variable, trace)) {
        for (const EntityIndex one : referents) {
          if (pedestrian.doubts(one, landmark, others))
            return GroundingFailure{
                RejectionReason::OddReference, to_text(test) + ": on foot it is not clearly the nearest", {}};
        }
      }
    }
  }
  return std::nullopt;
}

}  // namespace unietp
