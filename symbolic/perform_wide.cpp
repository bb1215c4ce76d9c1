#include <algorithm>

#include "symbolic/perform.h"

// What only the profile `wide` offers: simulation/extension_moves.cpp without geometry.
namespace unietp::symbolic {
namespace {

/// Not in the hand, and the hand gets at it.
Failure out_of_the_way(const Setting& setting, const World& world, Id thing) {
  return world.held == thing ? Failure::InvalidArgument : out_of_reach(setting, world, thing);
}

}  // namespace

Failure take_seat(const Setting& setting, World& world, Id thing, Predicate as) {
  const Kind& kind = setting.kind_of(thing);
  if (as == Predicate::LainOn ? !kind.lieable : !kind.sittable) return Failure::NotASeat;
  if (world.seat != kNobody) return Failure::Seated;
  if (const Failure blocked = out_of_the_way(setting, world, thing); blocked != Failure::None) return blocked;
  world[thing].set(as);
  world.seat = thing;
  return Failure::None;
}

Failure stand_up(World& world) {
  if (world.seat == kNobody) return Failure::NotSeated;
  world[world.seat].clear(Predicate::SatOn);
  world[world.seat].clear(Predicate::LainOn);
  world.seat = kNobody;
  return Failure::None;
}

Failure plug(const Setting& setting, World& world, Id thing, bool in) {
  Thing& device = world[thing];
  const bool plugged = device.has(Predicate::PluggedIn);
  if (!plugged && !device.has(Predicate::Unplugged)) return Failure::NotPluggable;
  if (const Failure blocked = out_of_the_way(setting, world, thing); blocked != Failure::None) return blocked;
  if (in == plugged) return in ? Failure::AlreadyPluggedIn : Failure::AlreadyUnplugged;
  device.set(in ? Predicate::PluggedIn : Predicate::Unplugged);
  if (!in && device.has(Predicate::PowerOn)) device.set(Predicate::PowerOff);
  return Failure::None;
}

Failure fold(const Setting& setting, World& world, Id thing) {
  if (!setting.kind_of(thing).foldable) return Failure::NotFoldable;
  if (world[thing].has(Predicate::Folded)) return Failure::AlreadyFolded;
  if (world.held != kNobody) return Failure::HandsFull;
  if (const Failure blocked = out_of_the_way(setting, world, thing); blocked != Failure::None) return blocked;
  const bool loaded = std::any_of(world.things.begin(), world.things.end(), [&](const Thing& other) {
    return other.exists && other.at == thing && (other.where == Where::On || other.where == Where::Inside);
  });
  if (loaded) return Failure::Blocked;
  world[thing].set(Predicate::Folded);
  return Failure::None;
}

Failure break_apart(const Setting& setting, World& world, Id thing) {
  if (!setting.kind_of(thing).breakable) return Failure::NotBreakable;
  if (world[thing].has(Predicate::Broken)) return Failure::AlreadyBroken;
  if (const Failure blocked = out_of_the_way(setting, world, thing); blocked != Failure::None) return blocked;
  world[thing].set(Predicate::Broken);
  if (world[thing].has(Predicate::Filled)) {
    world[thing].set(Predicate::Empty);
    world[thing].filling = {};
  }
  return Failure::None;
}

}  // namespace unietp::symbolic
