#include <algorithm>

#include "expert/methods.h"

// Room: for what is put down, and for doors and lids.
namespace unietp {
namespace {

constexpr std::size_t kMostCleared = 5;  // things carried out of the way of one

bool lacks_room(Failure failure) {
  return failure == Failure::NoFreePlace || failure == Failure::DidNotRest || failure == Failure::NoStandingPlace;
}

}  // namespace

bool Methods::lacked_room(const Attempt& attempt) {
  if (!attempt.trouble()) return true;  // no way was found at all
  const Failure failure = attempt.trouble()->failure;
  return lacks_room(failure) || failure == Failure::Blocked || attempt.exhausted();
}

bool Methods::is_named(const std::string& id) const {
  const auto names = [&](const Literal& literal) {
    return attempt_.id_of(literal.subject) == id || attempt_.id_of(literal.object) == id;
  };
  const Alternative& alternative = attempt_.alternative();
  return std::any_of(alternative.end.begin(), alternative.end.end(), names) ||
         std::any_of(alternative.moments.begin(), alternative.moments.end(), [&](const Moment& moment) {
           return std::any_of(moment.literals.begin(), moment.literals.end(), names);
         });
}

/// What is open takes more room than shut: a box with its lid up.
bool Methods::put_shut(const std::string& id, ActionType action, const std::string& target) {
  const auto& trouble = attempt_.trouble();
  const bool may_help = trouble && !attempt_.exhausted() && lacks_room(trouble->failure) && is(id, Predicate::Open);
  return may_help && directly(ActionType::Close, id) && hold(id) && do_at(action, target);
}

/// What lies on or in a target and the way to the goal does not speak of, the largest first.
std::vector<std::string> Methods::in_the_way_on(const std::string& target, const std::string& but) const {
  std::vector<std::pair<double, std::string>> there;
  for (const std::string& id : attempt_.world().resting_at(target)) {
    const Node& node = *find(id);
    if (node.movable && id != but && !is_named(id)) there.emplace_back(-node.size.x() * node.size.y(), id);
  }
  std::sort(there.begin(), there.end());
  if (there.size() > kMostCleared) there.resize(kMostCleared);
  std::vector<std::string> ids;
  for (auto& [less, id] : there) ids.push_back(std::move(id));
  return ids;
}

/// After there was no free place on or in a target: what is in the way is carried away from there.
bool Methods::make_room(const std::string& id, ActionType action, const std::string& target) {
  const auto crowded = [this] {
    const auto& trouble = attempt_.trouble();
    return trouble && !attempt_.exhausted() && lacks_room(trouble->failure);
  };
  if (!clears_ || !crowded()) return false;
  const std::vector<Action> again{
      {ActionType::GoTo, {id}}, {ActionType::PickUp, {id}}, {ActionType::GoTo, {target}}, {action, {target}}};
  bool cleared = false;
  // What could not be got at may stand behind what is gone by then.
  for (bool more = true; more && !works(again);) {
    more = false;
    for (const std::string& other : in_the_way_on(target, id)) {
      if (attempt_.exhausted()) return false;
      if (!carry_away(other, id, target)) continue;
      cleared = more = true;
      if (works(again)) break;
    }
  }
  return cleared && hold(id) && reopen(id, action, target) && do_at(action, target);
}

/// `other` from the target to where it is not in the way; `id` is out of the hand then.
bool Methods::carry_away(const std::string& other, const std::string& id, const std::string& target) {
  return put_aside(id, target) && hold(other) && put_aside(other, target);
}

/// The largest of the other things that are to come to the same place.
std::string Methods::next_for(const std::string& target, const std::string& but) const {
  std::string next;
  double most = 0;
  for (const Literal& literal : attempt_.alternative().end) {
    const Node* node = attempt_.node(literal.subject);
    if (node == nullptr || !node->movable || node->id == but || !literal.positive || attempt_.holds(literal)) continue;
    if (literal.predicate != Predicate::On && literal.predicate != Predicate::Inside) continue;
    const double room = node->size.x() * node->size.y();
    if (attempt_.id_of(literal.object) != target || room <= most) continue;
    most = room;
    next = node->id;
  }
  return next;
}

/// What is to be open at the end and is not yet.
bool Methods::still_opens(const std::string& id) const {
  const auto& end = attempt_.alternative().end;
  return !is(id, Predicate::Open) && std::any_of(end.begin(), end.end(), [&](const Literal& literal) {
    return literal.predicate == Predicate::Open && literal.positive && attempt_.id_of(literal.subject) == id;
  });
}

/// What a place is to leave room for: the next thing that comes there, and the lid that is opened there.
Postcondition Methods::room_at(const std::string& id, ActionType action, const std::string& target) const {
  const bool inside = action == ActionType::PlaceIn, opens = still_opens(id);
  const std::string next = next_for(target, id);
  Postcondition aim;
  aim.reached = [=](const World& world) {
    World later = world;
    if (opens && !later.step({ActionType::Open, {id}}).success) return false;
    return next.empty() || !later.free_spots_for(next, target, inside).empty();
  };
  if (next.empty()) return aim;
  const Vec3 size = find(id)->size, size_of_next = find(next)->size;
  const auto spots = attempt_.world().free_spots_for(next, target, inside);
  aim.at = [=](const Pose& spot) {
    const Bounds taken = bounds_of(spot, size);
    return std::any_of(spots.begin(), spots.end(),
                       [&](const Pose& other) { return !overlap(bounds_of(other, size_of_next), taken); });
  };
  return aim;
}

/// Where several things share a place: this one so that the next still finds room; and where a lid is to be opened: so
/// that it can be. At need after carrying away what is in the way.
bool Methods::leave_room(const std::string& id, ActionType action, const std::string& target) {
  if (!clears_ || (next_for(target, id).empty() && !still_opens(id))) return false;
  if (from_elsewhere({action, {target}}, target, room_at(id, action, target))) return true;
  for (const std::string& other : in_the_way_on(target, id)) {
    if (attempt_.exhausted()) return false;
    if (!carry_away(other, id, target)) continue;
    World trial = attempt_.world();
    const bool back = trial.step({ActionType::GoTo, {id}}).success && trial.step({ActionType::PickUp, {id}}).success;
    const Postcondition aim = room_at(id, action, target);
    if (!back || !steps_to_act(trial, {action, {target}}, target, aim)) continue;
    return hold(id) && reopen(id, action, target) && from_elsewhere({action, {target}}, target, aim);
  }
  // In vain: as if nothing was to come after it.
  if (!hold(id)) return false;
  return reopen(id, action, target) && do_at(action, target);
}

/// On or into something that lies inside the target, so that it is inside that, too.
bool Methods::nest(const std::string& id, const std::string& target) {
  if (!clears_ || attempt_.exhausted() || !hold(id) || !reopen(id, ActionType::PlaceIn, target)) return false;
  const Postcondition aim{[&](const World& world) { return world.linked(id, Predicate::Inside, target); }, {}};
  std::vector<std::string> there;
  for (const std::string& other : attempt_.world().resting_at(target)) {
    if (find(other)->movable && attempt_.world().linked(other, Predicate::Inside, target)) there.push_back(other);
  }
  for (const std::string& other : there) {
    for (const ActionType way : {ActionType::PlaceIn, ActionType::PlaceOn}) {
      if (from_elsewhere({way, {other}}, other, aim)) return true;
    }
  }
  return false;
}

/// After something was in the way of a door or a lid: an open door is shut; what can be carried is carried to where it
/// is not; or, where it cannot be carried, the thing itself is.
bool Methods::unblock(ActionType action, const std::string& id) {
  if (!clears_) return false;
  if (shut_in_the_way(action, id)) return true;
  for (std::size_t cleared = 0; cleared < kMostCleared; ++cleared) {
    const auto& trouble = attempt_.trouble();
    if (!trouble || trouble->failure != Failure::Blocked || attempt_.exhausted()) return false;
    const std::string blocker = trouble->blocker;
    const Node* other = find(blocker);
    if (other == nullptr || !other->movable || blocker == id) break;
    if (!hold(blocker)) return false;
    if (put_so_that(blocker, {{ActionType::GoTo, {id}}, {action, {id}}})) return true;
    if (!put_out_of_the_way(blocker, {action, {id}}) && (!put_aside(blocker) || attempt_.exhausted())) return false;
    if (do_at(action, id)) return true;
  }
  const Node* self = find(id);
  return self != nullptr && self->movable && hold(id) && put_so_that(id, {{action, {id}}});
}

/// The open door of another piece, but not of one that it stands in.
bool Methods::shut_in_the_way(ActionType action, const std::string& id) {
  const auto& trouble = attempt_.trouble();
  if (!trouble || trouble->failure != Failure::Blocked || attempt_.exhausted()) return false;
  const std::string blocker = trouble->blocker;
  const Node* other = find(blocker);
  const bool open = other != nullptr && !other->movable && is(blocker, Predicate::Open);
  if (!open || blocker == id || attempt_.world().linked(id, Predicate::Inside, blocker)) return false;
  return do_at(ActionType::Close, blocker) && do_at(action, id);
}

/// Puts what is held where further steps can be done afterwards, and does them.
bool Methods::put_so_that(const std::string& id, const std::vector<Action>& then) {
  PutDownOptions ways = put_down_options(id, "", "");
  while (const auto next = ways.next()) {
    const Action& way = *next;
    std::vector<Action> steps{{ActionType::GoTo, way.args}, way};
    steps.insert(steps.end(), then.begin(), then.end());
    if (works(steps))
      return std::all_of(steps.begin(), steps.end(), [this](const Action& step) { return attempt_.act(step); });
  }
  return false;
}

/// Puts what is held where it is not what an action is blocked by; something else may be.
bool Methods::put_out_of_the_way(const std::string& id, const Action& action) {
  PutDownOptions ways = put_down_options(id, "", "");
  while (const auto next = ways.next()) {
    const Action& way = *next;
    const std::vector<Action> steps{{ActionType::GoTo, way.args}, way};
    World trial = attempt_.world();
    const auto works = [&trial](const Action& step) { return trial.step(step).success; };
    if (!std::all_of(steps.begin(), steps.end(), works) || !works({ActionType::GoTo, action.args})) continue;
    const ActionResult outcome = trial.step(action);
    if (outcome.failure != Failure::Blocked || blocker_of(outcome) == id) continue;
    return std::all_of(steps.begin(), steps.end(), [this](const Action& step) { return attempt_.act(step); });
  }
  return false;
}

}  // namespace unietp
