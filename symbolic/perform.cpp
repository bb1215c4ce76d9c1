#include "symbolic/perform.h"

namespace unietp::symbolic {
namespace {

Failure go_to(World& world, Id target) {
  if (target.is_room()) {
    world.room = target;
    world.by = kNobody;
    return Failure::None;
  }
  if (world.held == target) return Failure::InvalidArgument;
  const Id root = root_of(world, target);
  if (world[root].where != PlaceKind::Floor) return Failure::NoStandingPlace;
  world.by = root;
  world.room = world[root].at;
  return Failure::None;
}

/// A thing that is lifted no longer has neighbors.
void leave_neighbors(World& world, Id thing) {
  world[thing].beside = kNobody;
  for (Thing& other : world.things) {
    if (other.beside == thing) other.beside = kNobody;
  }
}

Failure drop(const Setting& setting, World& world, const Step& step) {
  if (world.room == kNobody) return Failure::DidNotRest;
  if (step.beside != kNobody) {
    if (world.by != step.beside) return Failure::TooFar;
    if (step.under && setting.kind_of(step.beside).movable) return Failure::DoesNotFit;
  }
  Thing& thing = world[world.held];
  thing.where = PlaceKind::Floor;
  thing.at = world.room;
  thing.beside = step.beside;
  thing.under = step.under;
  world.held = kNobody;
  return Failure::None;
}

void lift(World& world, Id thing) {
  leave_neighbors(world, thing);
  world[thing].attached = false;
  world[thing].where = PlaceKind::Hand;
  world[thing].at = kNobody;
  world.held = thing;
  if (world.by == thing) world.by = kNobody;
}

Failure place(const Setting& setting, World& world, const Step& step) {
  const Id item = world.held;
  const Id target = step.target;
  const bool inside = step.action == ActionType::PlaceIn;
  if (inside && setting.kind_of(target).openable && !world[target].has(Predicate::Open))
    return Failure::ReceptacleClosed;
  const Predicate relation = inside ? Predicate::Inside : Predicate::On;
  if (setting.rules->capacity(setting.kind_number(item), relation, setting.kind_number(target)) == 0)
    return Failure::DoesNotFit;
  if (!has_room(setting, world, item, relation, target)) return Failure::NoFreePlace;
  const PlaceKind where = inside ? PlaceKind::Inside : PlaceKind::On;
  if (step.beside != kNobody && (world[step.beside].where != where || world[step.beside].at != target))
    return Failure::NoFreePlace;
  Thing& thing = world[item];
  thing.where = where;
  thing.at = target;
  thing.beside = step.beside;
  thing.under = false;
  thing.attached =
      !inside && setting.rules->capabilities().attaching &&
      setting.rules->reaction(setting.kind_number(target), Treatment::Attaches, setting.kind_number(item)) != nullptr;
  world.held = kNobody;
  run_processes(setting, world, target, false);
  return Failure::None;
}

void stand_up(World& world) {
  world[world.seat].clear(Predicate::SatOn);
  world[world.seat].clear(Predicate::LainOn);
  world.seat = kNobody;
}

/// The changes of a direct action.
void change(const Setting& setting, World& world, const ActionInfo& action, Id id) {
  Thing& thing = world[id];
  for (const ActionChange& change : action.changes) {
    if (change.only_if && !thing.has(*change.only_if)) continue;
    thing.set(change.state);
    if (change.state == Predicate::Empty) thing.filling = {};
    if (change.state == Predicate::SatOn || change.state == Predicate::LainOn) world.seat = id;
  }
  if (action.starts_tool) run_processes(setting, world, id, false);
}

/// Uses the first effect of the tool that belongs to the action.
Failure treat(const Setting& setting, World& world, const Step& step, std::vector<World>* passed) {
  for (const TreatmentInfo& row : all_treatments()) {
    if (row.treats != step.action) continue;
    const Failure failure = treat_with(setting, world, step.target, row.treatment, passed);
    if (failure != Failure::NoEffect) return failure;
  }
  return Failure::NoEffect;
}

Failure carry_out(const Setting& setting, World& world, const Step& step, std::vector<World>* passed) {
  switch (step.action) {
    case ActionType::GoTo:
      return go_to(world, step.target);
    case ActionType::PickUp:
      lift(world, step.target);
      return Failure::None;
    case ActionType::PlaceOn:
    case ActionType::PlaceIn:
      return place(setting, world, step);
    case ActionType::Drop:
      return drop(setting, world, step);
    case ActionType::Slice:
      return slice(setting, world, step.target);
    case ActionType::PourTo:
      return pour_to(setting, world, step.target);
    case ActionType::Wipe:
      return wipe(setting, world, step.target);
    case ActionType::SpreadTo:
      return spread_to(setting, world, step.target);
    case ActionType::StandUp:
      stand_up(world);
      return Failure::None;
    default:
      break;
  }
  const ActionInfo& action = info(step.action);
  if (action.argument == ActionArgument::Tool) return treat(setting, world, step, passed);
  if (!action.changes.empty()) change(setting, world, action, step.target);
  return Failure::None;
}

}  // namespace

std::string to_text(const Setting& setting, const Step& step) {
  std::string text(info(step.action).name);
  if (step.target != kNobody) text += "(" + name_of(setting, step.target) + ")";
  if (step.beside != kNobody) text += (step.under ? " under " : " beside ") + name_of(setting, step.beside);
  return text;
}

Failure perform(const Setting& setting, World& world, const Step& step, std::vector<World>* passed) {
  if (!setting.rules->capabilities().has(step.action)) return Failure::NotOffered;
  const ActionArgument argument = info(step.action).argument;
  const bool on_thing = argument == ActionArgument::Object || argument == ActionArgument::Tool;
  if (on_thing && (!step.target.is_thing() || !world[step.target].exists)) return Failure::InvalidArgument;
  return perform_checked(setting, world, step, passed);
}

Failure perform_checked(const Setting& setting, World& world, const Step& step, std::vector<World>* passed) {
  const Failure unmet = first_unmet(setting, world, step);
  return unmet != Failure::None ? unmet : carry_out(setting, world, step, passed);
}

Failure out_of_reach(const Setting& setting, const World& world, Id thing) {
  if (closed_around(setting, world, thing) != kNobody) return Failure::InsideClosed;
  return world.by != kNobody && root_of(world, thing) == world.by ? Failure::None : Failure::TooFar;
}

bool has_room(const Setting& setting, const World& world, Id thing, Predicate relation, Id place) {
  const int own = setting.rules->capacity(setting.kind_number(thing), relation, setting.kind_number(place));
  if (own == 0) return false;
  const PlaceKind where = relation == Predicate::On ? PlaceKind::On : PlaceKind::Inside;
  int there = 0;
  for (std::size_t i = 0; i < world.things.size(); ++i) {
    const auto other = Id::thing(i);
    if (other == thing || !world[other].exists || world[other].where != where || world[other].at != place) continue;
    there += setting.kind_number(other) == setting.kind_number(thing) ? 1 : 0;
  }
  return there < own;
}

}  // namespace unietp::symbolic
