#include "grounding/nearness_on_foot.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numbers>
#include <queue>
#include <string>
#include <utility>

#include "grounding/goal_places.h"
#include "logic/evaluate.h"
#include "scene/geometry.h"
#include "scene/size_and_nearness.h"

namespace unietp {
namespace {

using Op = Formula::Op;
constexpr double kNoWay = std::numeric_limits<double>::infinity();

/// Whether a test says "the nearest to some ?b".
bool asks_for_nearest(const Formula& test, const std::string& variable) {
  return test.op == Op::Exists && test.children.front() == atom(Predicate::Nearest, {variable, test.variable});
}

class Pedestrian {
 public:
  Pedestrian(const Scene& scene, const NodeIndex& places, const Trace& trace, const Walk& walk)
      : scene_(scene), places_(places), trace_(trace), walk_(walk) {}

  /// The one of these things that is clearly the nearest to a landmark in the landmark's room, if there is one.
  std::optional<EntityIndex> nearest_to(EntityIndex landmark, const std::vector<EntityIndex>& things) const {
    const Room* room = room_of(landmark);
    const Node* from = node_of(landmark);
    if (room == nullptr || from == nullptr) return std::nullopt;
    const RoomWalk ways(walk_, *room, from->pose.position.head<2>());
    std::vector<std::pair<double, EntityIndex>> found;
    for (const EntityIndex thing : things) {
      const Node* node = node_of(thing);
      if (node == nullptr || room_of(thing) != room) continue;
      if (const auto way = ways.meters_to(node->pose.position.head<2>())) found.emplace_back(*way, thing);
    }
    std::sort(found.begin(), found.end());
    if (found.empty() || (found.size() > 1 && !clearly_nearer(found[0].first, found[1].first))) return std::nullopt;
    return found.front().second;
  }

 private:
  const Room* room_of(EntityIndex thing) const {
    const auto here = std::find_if(scene_.rooms.begin(), scene_.rooms.end(), [&](const Room& room) {
      return trace_.states.front().any_related(Predicate::InRoom, thing,
                                               [&](EntityIndex one) { return trace_.entities[one].id == room.id; });
    });
    return here == scene_.rooms.end() ? nullptr : &*here;
  }
  const Node* node_of(EntityIndex thing) const {
    const auto place = places_.find(trace_.entities[thing].id);
    return place ? &scene_.nodes[*place] : nullptr;
  }

  const Scene& scene_;
  const NodeIndex& places_;
  const Trace& trace_;
  const Walk& walk_;
};

/// Whether the things that are meant are those that are nearest on foot, too.
bool are_nearest(const Pedestrian& pedestrian, const Formula& test, const ReferredThings& meant, const Trace& trace) {
  std::vector<EntityIndex> all = meant.referents;
  all.insert(all.end(), meant.others.begin(), meant.others.end());
  std::vector<EntityIndex> missed = meant.referents;
  for (const EntityIndex landmark : members_of(test.domain, test.variable, trace)) {
    const auto nearest = pedestrian.nearest_to(landmark, all);
    if (!nearest) continue;
    if (std::find(meant.others.begin(), meant.others.end(), *nearest) != meant.others.end()) return false;
    if (trace.states.front().holds(Predicate::Nearest, *nearest, landmark)) std::erase(missed, *nearest);
  }
  return missed.empty();
}

}  // namespace

RoomWalk::RoomWalk(const Walk& walk, const Room& room, const Vec2& from) : grid_(walk.grid) {
  Vec2 low = room.polygon.front(), high = low;
  for (const Vec2& corner : room.polygon) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  low_ = grid_.cell_at(low);
  high_ = grid_.cell_at(high);
  width_ = static_cast<std::size_t>(high_.x - low_.x) + 1;
  for (int y = low_.y; y <= high_.y; ++y) {
    for (int x = low_.x; x <= high_.x; ++x)
      of_room_.push_back(walk.reached.has(x, y) && contains(room.polygon, grid_.center({x, y})));
  }
  meters_.assign(of_room_.size(), kNoWay);
  const auto first = nearest(from);
  if (!first) return;
  before_ = (grid_.center(*first) - from).norm();
  spread(*first);
}

bool RoomWalk::is_of_room(Cell cell) const {
  return cell.x >= low_.x && cell.x <= high_.x && cell.y >= low_.y && cell.y <= high_.y && of_room_[place(cell)];
}

std::optional<RoomWalk::Cell> RoomWalk::nearest(const Vec2& point) const {
  std::optional<Cell> best;
  double least = kNoWay;
  for (int y = low_.y; y <= high_.y; ++y) {
    for (int x = low_.x; x <= high_.x; ++x) {
      const double away = is_of_room({x, y}) ? (grid_.center({x, y}) - point).squaredNorm() : kNoWay;
      if (away >= least) continue;
      least = away;
      best = Cell{x, y};
    }
  }
  return best;
}

void RoomWalk::spread(Cell from) {
  using Reached = std::pair<double, std::size_t>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> next;
  meters_[place(from)] = 0;
  next.emplace(0, place(from));
  while (!next.empty()) {
    const auto [meters, index] = next.top();
    next.pop();
    if (meters > meters_[index]) continue;
    const Cell here{low_.x + static_cast<int>(index % width_), low_.y + static_cast<int>(index / width_)};
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell there{here.x + dx, here.y + dy};
        if (!is_of_room(there) || !is_of_room({here.x + dx, here.y}) || !is_of_room({here.x, here.y + dy})) continue;
        const double length = dx != 0 && dy != 0 ? std::numbers::sqrt2 : 1;
        const double way = meters + length * NavigationGrid::kCell_m;
        if (way >= meters_[place(there)]) continue;
        meters_[place(there)] = way;
        next.emplace(way, place(there));
      }
    }
  }
}

std::optional<double> RoomWalk::meters_to(const Vec2& point) const {
  const auto last = nearest(point);
  if (!last || meters_[place(*last)] == kNoWay) return std::nullopt;
  return before_ + meters_[place(*last)] + (grid_.center(*last) - point).norm();
}

std::optional<GroundingFailure> check_nearness_on_foot(const Formula& goal, const Scene& scene, const NodeIndex& places,
                                                       const Trace& trace, const Walk& walk) {
  const Pedestrian pedestrian(scene, places, trace, walk);
  for (const ReferredThings& meant : referred_things(goal, trace)) {
    const Formula& where = meant.domain.domain.where.front();
    const auto tests = where.op == Op::And ? where.children : std::vector<Formula>{where};
    for (const Formula& test : tests) {
      if (asks_for_nearest(test, meant.domain.variable) && !are_nearest(pedestrian, test, meant, trace))
        return GroundingFailure{
            RejectionReason::OddReference, to_text(test) + ": on foot it is not clearly the nearest", {}};
    }
  }
  return std::nullopt;
}

}  // namespace unietp
