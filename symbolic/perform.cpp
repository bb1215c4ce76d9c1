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

Failure place(const Setting& setting, World& world, const Step& step, Predicate relation) {
  const Id item = world.held;
  const Id target = step.target;
  if (!has_room(setting, world, item, relation, target)) return Failure::NoFreePlace;
  const PlaceKind where = relation == Predicate::Inside ? PlaceKind::Inside : PlaceKind::On;
  if (step.beside != kNobody && (world[step.beside].where != where || world[step.beside].at != target))
    return Failure::NoFreePlace;
  Thing& thing = world[item];
  thing.where = where;
  thing.at = target;
  thing.beside = step.beside;
  thing.under = false;
  thing.attached =
      relation == Predicate::On && setting.rules->capabilities().attaching &&
      setting.rules->reaction(setting.kind_number(target), Treatment::Attaches, setting.kind_number(item)) != nullptr;
  world.held = kNobody;
  return Failure::None;
}

void stand_up(World& world) {
  world[world.seat].clear(Predicate::SatOn);
  world[world.seat].clear(Predicate::LainOn);
  world.seat = kNobody;
}

/// Makes one change of the action's row.
Failure change(const Setting& setting, World& world, const Step& step, const ActionChange& change) {
  const Id id = change.of == ActionChange::Of::Held ? world.held : step.target;
  Thing& thing = world[id];
  if (change.only_if && !thing.has(*change.only_if)) return Failure::None;
  switch (change.state) {
    case Predicate::Held:
      lift(world, id);
      return Failure::None;
    case Predicate::On:
    case Predicate::Inside:
      return place(setting, world, step, change.state);
    case Predicate::OnFloor:
      return drop(setting, world, step);
    case Predicate::Sliced:
      return slice(setting, world, id);
    case Predicate::Covered:
      if (change.ends) {
        thing.coats.clear();
      } else {
        thing.coats.insert(
            setting.rules->reaction(setting.kind_number(world.held), Treatment::Dispenses, setting.kind_number(id))
                ->symbol);
      }
      return Failure::None;
    default:
      break;
  }
  thing.set(change.state);
  if (change.state == Predicate::Filled) thing.filling = world[world.held].filling;
  if (change.state == Predicate::Empty) thing.filling = {};
  if (change.state == Predicate::SatOn || change.state == Predicate::LainOn) world.seat = id;
  return Failure::None;
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
  const ActionInfo& action = info(step.action);
  if (step.action == ActionType::GoTo) return go_to(world, step.target);
  if (step.action == ActionType::StandUp) stand_up(world);
  if (action.argument == ActionArgument::Tool) return treat(setting, world, step, passed);
  for (const ActionChange& one : action.changes) {
    if (!applies(setting, world, one.rule, step.target)) continue;
    if (const Failure failure = change(setting, world, step, one); failure != Failure::None) return failure;
  }
  if (action.starts_tool) run_processes(setting, world, step.target, false);
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
