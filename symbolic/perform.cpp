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
  if (world[root].where != Where::Floor) return Failure::NoStandingPlace;
  world.by = root;
  world.room = world[root].at;
  return Failure::None;
}

/// What stood beside a thing no longer does once it is lifted.
void leave_neighbours(World& world, Id thing) {
  world[thing].beside = kNobody;
  for (Thing& other : world.things) {
    if (other.beside == thing) other.beside = kNobody;
  }
}

Failure drop(const Setting& setting, World& world, const Step& step) {
  if (world.held == kNobody) return Failure::NotHolding;
  if (world.room == kNobody) return Failure::DidNotRest;
  if (step.beside != kNobody) {
    if (world.by != step.beside) return Failure::TooFar;
    if (step.under && setting.kind_of(step.beside).movable) return Failure::DoesNotFit;
  }
  Thing& thing = world[world.held];
  thing.where = Where::Floor;
  thing.at = world.room;
  thing.beside = step.beside;
  thing.under = step.under;
  world.held = kNobody;
  return Failure::None;
}

Failure cool_with(const Setting& setting, World& world, Id tool) {
  const Failure cooled = treat_with(setting, world, tool, Treatment::Cools);
  return cooled == Failure::NoEffect ? treat_with(setting, world, tool, Treatment::Freezes) : cooled;
}

Failure perform_on(const Setting& setting, World& world, const Step& step) {
  const Id id = step.target;
  switch (step.action) {
    case ActionType::PickUp:
      return pick_up(setting, world, id);
    case ActionType::PlaceOn:
    case ActionType::PlaceIn:
      return place(setting, world, step);
    case ActionType::Open:
      return swing(setting, world, id, true);
    case ActionType::Close:
      return swing(setting, world, id, false);
    case ActionType::TurnOn:
      return switch_power(setting, world, id, true);
    case ActionType::TurnOff:
      return switch_power(setting, world, id, false);
    case ActionType::Slice:
      return slice(setting, world, id);
    case ActionType::PourTo:
      return pour_to(setting, world, id);
    case ActionType::UseUp:
      return use_up(setting, world, id);
    case ActionType::Wipe:
      return wipe(setting, world, id);
    case ActionType::SpreadTo:
      return spread_to(setting, world, id);
    case ActionType::SoakWith:
      return treat_with(setting, world, id, Treatment::Soaks);
    case ActionType::HeatWith:
      return treat_with(setting, world, id, Treatment::Heats);
    case ActionType::CoolWith:
      return cool_with(setting, world, id);
    case ActionType::WashWith:
      return treat_with(setting, world, id, Treatment::Washes);
    case ActionType::CookWith:
      return treat_with(setting, world, id, Treatment::Cooks);
    case ActionType::BurnWith:
      return treat_with(setting, world, id, Treatment::Burns);
    case ActionType::FillWith:
      return treat_with(setting, world, id, Treatment::Fills);
    case ActionType::SitOn:
      return take_seat(setting, world, id, Predicate::SatOn);
    case ActionType::LieOn:
      return take_seat(setting, world, id, Predicate::LainOn);
    case ActionType::PlugIn:
      return plug(setting, world, id, true);
    case ActionType::Unplug:
      return plug(setting, world, id, false);
    case ActionType::Fold:
      return fold(setting, world, id);
    case ActionType::Break:
      return break_apart(setting, world, id);
    case ActionType::TurnTo:
      return out_of_reach(setting, world, id);
    default:
      return Failure::InvalidAction;
  }
}

}  // namespace

std::string to_text(const Setting& setting, const Step& step) {
  std::string text(info(step.action).name);
  if (step.target != kNobody) text += "(" + name_of(setting, step.target) + ")";
  if (step.beside != kNobody) text += (step.under ? " under " : " beside ") + name_of(setting, step.beside);
  return text;
}

Failure perform(const Setting& setting, World& world, const Step& step) {
  if (!setting.rules->offer().has(step.action)) return Failure::NotOffered;
  const ActionInfo& about = info(step.action);
  if (step.action == ActionType::StandUp) return stand_up(world);
  if (world.seat != kNobody && (about.group == ActionClass::Movement || step.action == ActionType::GoTo) &&
      step.action != ActionType::LookUp && step.action != ActionType::LookDown)
    return Failure::Seated;
  if (step.action == ActionType::GoTo) return go_to(world, step.target);
  if (step.action == ActionType::Drop) return drop(setting, world, step);
  if (about.argument == ActionArgument::None) return Failure::None;
  if (!step.target.is_thing() || !world[step.target].exists) return Failure::InvalidArgument;
  return perform_on(setting, world, step);
}

Failure out_of_reach(const Setting& setting, const World& world, Id thing) {
  if (closed_around(setting, world, thing) != kNobody) return Failure::InsideClosed;
  return world.by != kNobody && root_of(world, thing) == world.by ? Failure::None : Failure::TooFar;
}

bool has_room(const Setting& setting, const World& world, Id thing, Predicate relation, Id place) {
  const int own = setting.rules->capacity(setting.kind_number(thing), relation, setting.kind_number(place));
  if (own == 0) return false;
  const Where where = relation == Predicate::On ? Where::On : Where::Inside;
  int there = 0;
  for (std::size_t i = 0; i < world.things.size(); ++i) {
    const auto other = Id::thing(i);
    if (other == thing || !world[other].exists || world[other].where != where || world[other].at != place) continue;
    there += setting.kind_number(other) == setting.kind_number(thing) ? 1 : 0;
  }
  return there < own;
}

Failure pick_up(const Setting& setting, World& world, Id thing) {
  if (world.held == thing) return Failure::InvalidArgument;
  if (!setting.kind_of(thing).pickupable) return Failure::NotPickupable;
  if (world.seat == thing) return Failure::Seated;
  if (world.held != kNobody) return Failure::HandsFull;
  if (const Failure blocked = out_of_reach(setting, world, thing); blocked != Failure::None) return blocked;
  leave_neighbours(world, thing);
  world[thing].attached = false;
  world[thing].where = Where::Hand;
  world[thing].at = kNobody;
  world.held = thing;
  if (world.by == thing) world.by = kNobody;
  return Failure::None;
}

Failure place(const Setting& setting, World& world, const Step& step) {
  if (world.held == kNobody) return Failure::NotHolding;
  const Id item = world.held;
  const Id target = step.target;
  if (target == item || rests_on(world, target, item)) return Failure::InvalidArgument;
  if (const Failure blocked = out_of_reach(setting, world, target); blocked != Failure::None) return blocked;
  const bool inside = step.action == ActionType::PlaceIn;
  if (inside && setting.kind_of(target).openable && !world[target].has(Predicate::Open))
    return Failure::ReceptacleClosed;
  const Predicate relation = inside ? Predicate::Inside : Predicate::On;
  if (setting.rules->capacity(setting.kind_number(item), relation, setting.kind_number(target)) == 0)
    return Failure::DoesNotFit;
  if (!has_room(setting, world, item, relation, target)) return Failure::NoFreePlace;
  const Where where = inside ? Where::Inside : Where::On;
  if (step.beside != kNobody && (world[step.beside].where != where || world[step.beside].at != target))
    return Failure::NoFreePlace;
  Thing& thing = world[item];
  thing.where = where;
  thing.at = target;
  thing.beside = step.beside;
  thing.under = false;
  thing.attached =
      !inside && setting.rules->offer().attaching &&
      setting.rules->reaction(setting.kind_number(target), Treatment::Attaches, setting.kind_number(item)) != nullptr;
  world.held = kNobody;
  run_processes(setting, world, target, false);
  return Failure::None;
}

Failure swing(const Setting& setting, World& world, Id thing, bool open) {
  if (!setting.kind_of(thing).openable) return Failure::NotOpenable;
  if (world.held == thing) return Failure::InvalidArgument;
  if (const Failure blocked = out_of_reach(setting, world, thing); blocked != Failure::None) return blocked;
  const bool is_open = world[thing].has(Predicate::Open);
  if (open == is_open) return open ? Failure::AlreadyOpen : Failure::AlreadyClosed;
  if (open && setting.rules->offer().open_needs_power_off && world[thing].has(Predicate::PowerOn))
    return Failure::AlreadyOn;
  world[thing].set(open ? Predicate::Open : Predicate::Closed);
  run_processes(setting, world, thing, false);
  return Failure::None;
}

Failure switch_power(const Setting& setting, World& world, Id thing, bool on) {
  const Thing& device = world[thing];
  if (!device.has(Predicate::PowerOn) && !device.has(Predicate::PowerOff)) return Failure::NotSwitchable;
  if (world.held != thing) {
    if (const Failure blocked = out_of_reach(setting, world, thing); blocked != Failure::None) return blocked;
  }
  if (on && device.has(Predicate::PowerOn)) return Failure::AlreadyOn;
  if (!on && device.has(Predicate::PowerOff)) return Failure::AlreadyOff;
  if (on && setting.rules->offer().power_needs_closed && setting.kind_of(thing).shuts_to_run &&
      device.has(Predicate::Open))
    return Failure::MustBeClosed;
  if (on && setting.rules->offer().power_needs_plug && device.has(Predicate::Unplugged)) return Failure::NotPluggedIn;
  world[thing].set(on ? Predicate::PowerOn : Predicate::PowerOff);
  run_processes(setting, world, thing, false);
  return Failure::None;
}

}  // namespace unietp::symbolic
