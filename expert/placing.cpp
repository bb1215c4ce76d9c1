#include <algorithm>
#include <tuple>

#include "expert/methods.h"
#include "simulation/relations.h"

// Where things go: into the hand, to a place, out of the way.
namespace unietp {
namespace {

/// As `next_to` is read, of boxes that may yet come down.
bool side_by_side(const Bounds& a, const Bounds& b) {
  const double dx = std::max(a.low.x() - b.high.x(), b.low.x() - a.high.x());
  const double dy = std::max(a.low.y() - b.high.y(), b.low.y() - a.high.y());
  return std::max(dx, dy) > 0 && std::hypot(std::max(dx, 0.0), std::max(dy, 0.0)) <= kNextTo_m;
}

}  // namespace

bool Methods::place(const Literal& literal) {
  const std::string id = attempt_.id_of(literal.subject), target = attempt_.id_of(literal.object);
  if (target.empty()) return false;
  switch (literal.predicate) {
    case Predicate::On:
    case Predicate::Attached:  // what the tables say attaches does so where it is put
      return put(id, ActionType::PlaceOn, target);
    case Predicate::Inside:
      return put(id, ActionType::PlaceIn, target);
    case Predicate::OnFloor:
      return hold(id) && let_fall(id, target);
    case Predicate::InRoom:
      return id == "agent" ? attempt_.act(ActionType::GoTo, target) : place_in_room(id, target);
    case Predicate::NextTo:
      return place_beside(id, target);
    default:
      return false;
  }
}

/// In the middle of the room or, where it would fall on something, elsewhere in it.
bool Methods::let_fall(const std::string& id, const std::string& room) {
  const Postcondition aim{[&](const World& world) {
                            const auto floors = world.linked_from(id, Predicate::OnFloor);
                            return std::find(floors.begin(), floors.end(), room) != floors.end();
                          },
                          {}};
  return from_elsewhere({ActionType::Drop, {}}, room, aim);
}

/// What can be put where the neighbor stands: on what carries it, into what it lies in, on furniture beside it, or let
/// fall there.
std::vector<Action> Methods::ways_beside(const std::string& neighbor) const {
  const World& world = attempt_.world();
  std::vector<Action> ways;
  for (const std::string& support : world.linked_from(neighbor, Predicate::On))
    ways.push_back({ActionType::PlaceOn, {support}});
  for (const std::string& around : world.linked_from(neighbor, Predicate::Inside))
    ways.push_back({ActionType::PlaceIn, {around}});
  const Node& node = *find(neighbor);
  const Bounds bounds = bounds_of(node.pose, node.size);
  for (const Node& other : world.nodes()) {
    if (other.movable || other.id == neighbor || !side_by_side(bounds, bounds_of(other.pose, other.size))) continue;
    ways.push_back({ActionType::PlaceOn, {other.id}});
    if (!other.openable || is(other.id, Predicate::Open)) ways.push_back({ActionType::PlaceIn, {other.id}});
  }
  if (attempt_.situation().profile.offers(ActionType::Drop)) ways.push_back({ActionType::Drop, {}});
  return ways;
}

/// Where the neighbor is; or, where there is no room beside it, where there is room for both.
bool Methods::place_beside(const std::string& id, const std::string& neighbor) {
  if (attempt_.is_held(neighbor) && !put_aside(neighbor)) return false;
  if (!open_around(neighbor)) return false;
  if (hold(id) && set_beside(id, neighbor)) return true;
  return clears_ && find(neighbor)->movable && put_together(id, neighbor);
}

/// The neighbor first, to where the other comes to stand beside it.
bool Methods::put_together(const std::string& id, const std::string& neighbor) {
  if (!hold(neighbor)) return false;
  const Postcondition aim{[&](const World& world) { return world.linked(id, Predicate::NextTo, neighbor); }, {}};
  PutDownOptions ways = put_down_options(neighbor, "", "");
  while (const auto next = ways.next()) {
    const Action& way = *next;
    const std::vector<Action> steps{
        {ActionType::GoTo, way.args}, way, {ActionType::GoTo, {id}}, {ActionType::PickUp, {id}}};
    World trial = attempt_.world();
    if (!std::all_of(steps.begin(), steps.end(), [&](const Action& step) { return trial.step(step).success; }))
      continue;
    if (!steps_to_act(trial, way, neighbor, aim)) continue;
    return std::all_of(steps.begin(), steps.end(), [this](const Action& step) { return attempt_.act(step); }) &&
           from_elsewhere(way, neighbor, aim);
  }
  return false;
}

bool Methods::set_beside(const std::string& id, const std::string& neighbor) {
  const Vec3 size = find(id)->size;
  const Node& other = *find(neighbor);
  const Bounds there = bounds_of(other.pose, other.size);
  const Postcondition aim{[&](const World& world) { return world.linked(id, Predicate::NextTo, neighbor); },
                          [&](const Pose& spot) { return side_by_side(bounds_of(spot, size), there); }};
  for (const Action& way : ways_beside(neighbor)) {
    if (from_elsewhere(way, neighbor, aim)) return true;
    if (attempt_.exhausted()) return false;
  }
  return false;
}

bool Methods::place_in_room(const std::string& id, const std::string& room) {
  if (!hold(id)) return false;
  return put_down_in(id, room) || (shut_out_of_the_way(room) && put_down_in(id, room));
}

/// On the furniture that it is usual on, then on or in any other; on the floor only where there is nothing else.
bool Methods::put_down_in(const std::string& id, const std::string& room) {
  PutDownOptions ways = put_down_options(id, room, "");
  std::vector<Action> tried;
  while (const auto way = ways.next()) {
    if (works_at(*way)) return do_at(way->type, way->args.front());
    tried.push_back(*way);
  }
  if (works({{ActionType::GoTo, {room}}, {ActionType::Drop, {}}}))
    return attempt_.act(ActionType::GoTo, room) && attempt_.act(ActionType::Drop);
  for (const Action& way : tried) {
    if (from_elsewhere(way, way.args.front(), {})) return true;
  }
  const Postcondition aim{[&](const World& world) { return world.room_of(id) == room; }, {}};
  if (attempt_.situation().profile.offers(ActionType::Drop) && from_elsewhere({ActionType::Drop, {}}, room, aim))
    return true;
  return attempt_.act(ActionType::GoTo, room) && attempt_.act(ActionType::Drop);
}

/// In the hand a thing is on and in nothing; only a room needs it carried out.
bool Methods::take_away(const Literal& literal) {
  const std::string id = attempt_.id_of(literal.subject);
  if (literal.predicate != Predicate::InRoom) return hold(id);
  for (const Room& room : attempt_.situation().start->rooms) {
    if (room.id != attempt_.id_of(literal.object)) return place_in_room(id, room.id);
  }
  return false;
}

bool Methods::hold(const std::string& id) {
  if (attempt_.is_held(id)) return true;
  return free_hand(id) && do_at(ActionType::PickUp, id);
}

bool Methods::free_hand(const std::string& wanted) {
  const auto hands = static_cast<std::size_t>(attempt_.situation().profile.hands);
  while (attempt_.world().agent().held.size() >= hands) {
    const std::string held = attempt_.world().agent().held.front();
    if (held == wanted) return true;
    if (!put_aside(held)) return false;
  }
  return true;
}

PutDownOptions Methods::put_down_options(const std::string& id, const std::string& room,
                                         const std::string& except) const {
  return {attempt_.world(), *attempt_.situation().knowledge, {id, room, except, relevant_}};
}

bool Methods::put_aside(const std::string& id, const std::string& except) {
  if (!attempt_.is_held(id)) return true;
  PutDownOptions ways = put_down_options(id, "", except);
  std::vector<Action> tried;
  while (const auto way = ways.next()) {
    if (works_at(*way) && do_at(way->type, way->args.front())) return true;
    if (attempt_.exhausted()) return false;
    tried.push_back(*way);
  }
  if (attempt_.situation().profile.offers(ActionType::Drop) && attempt_.act(ActionType::Drop)) return true;
  return std::any_of(tried.begin(), tried.end(),
                     [this](const Action& way) { return from_elsewhere(way, way.args.front(), {}); });
}

bool Methods::works(const std::vector<Action>& steps) const {
  World trial = attempt_.world();
  return std::all_of(steps.begin(), steps.end(), [&trial](const Action& step) { return trial.step(step).success; });
}

bool Methods::works_at(const Action& action) const {
  const std::string& id = action.args.front();
  return (attempt_.world().in_reach(id) && works({action})) || works({{ActionType::GoTo, {id}}, action});
}

bool Methods::put(const std::string& id, ActionType action, const std::string& target) {
  if (attempt_.is_held(target) && !put_aside(target)) return false;
  if (!hold(id) || !reopen(id, action, target)) return false;
  return leave_room(id, action, target) || do_at(action, target) || put_shut(id, action, target) ||
         make_room(id, action, target) || (action == ActionType::PlaceIn && nest(id, target));
}

/// What the thing in the hand goes into is open afterwards.
bool Methods::reopen(const std::string& id, ActionType action, const std::string& target) {
  const Node* into = find(target);
  const bool shut = action == ActionType::PlaceIn && into != nullptr && into->openable && !is(target, Predicate::Open);
  if (shut && !directly(ActionType::Open, target)) {
    const auto& trouble = attempt_.trouble();
    if (!trouble || trouble->failure != Failure::HandsFull || attempt_.exhausted()) return false;
    if (!put_aside(id) || !directly(ActionType::Open, target)) return false;
  }
  return hold(id);
}

/// As `put`, where the hand can take it back.
bool Methods::put_in_grasp(const std::string& id, ActionType action, const std::string& target) {
  const Node* into = find(target);
  const bool shut = action == ActionType::PlaceIn && into != nullptr && into->openable && !is(target, Predicate::Open);
  if (!hold(id) || (shut && !directly(ActionType::Open, target)) || !hold(id)) return put(id, action, target);
  const Postcondition aim{[&](const World& world) { return world.in_reach(id); }, {}};
  return from_elsewhere({action, {target}}, target, aim) || put(id, action, target);
}

}  // namespace unietp
