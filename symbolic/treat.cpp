#include <array>

#include "symbolic/perform.h"

// What tools and appliances do, and what is cut, poured, wiped, spread and used up: simulation/effects.cpp and
// simulation/contents.cpp without geometry.
namespace unietp::symbolic {
namespace {

bool needs_met(const Setting& setting, const World& world, const Reaction& reaction, Id tool, Id thing, bool tap_runs) {
  const auto asks = [&](Need need) { return (reaction.needs & need) != 0; };
  if (asks(kUnknown) || asks(kHeld)) return false;
  if (asks(kClosed) && setting.kind_of(tool).openable && !world[tool].has(Predicate::Closed)) return false;
  if (asks(kPowerOn) && world[tool].has(Predicate::PowerOff)) return false;
  if (asks(kInside) && !is_inside(world, thing, tool)) return false;
  if (asks(kOn) && !holds(setting, world, Predicate::On, thing, tool, kAnySymbol)) return false;
  return !asks(kUnderTap) || tap_runs || world[tool].has(Predicate::PowerOn);
}

const Reaction* by_hand(const Setting& setting, const World& world, Treatment treatment, Id thing) {
  return setting.rules->reaction(setting.kind_number(world.held), treatment, setting.kind_number(thing));
}

}  // namespace

const std::vector<Predicate>& sets(Treatment treatment) {
  using enum Predicate;
  static const std::array<std::vector<Predicate>, kTreatments> kSets{
      {{Hot}, {Cool}, {Frozen, Cool}, {Cooked, Hot}, {Burnt, Hot}, {Clean}, {Soaked}, {Filled}, {}, {}, {}, {}, {}}};
  return kSets[static_cast<std::size_t>(treatment)];
}

std::optional<ActionType> action_for(Treatment treatment) {
  switch (treatment) {
    case Treatment::Heats:
      return ActionType::HeatWith;
    case Treatment::Cools:
    case Treatment::Freezes:
      return ActionType::CoolWith;
    case Treatment::Cooks:
      return ActionType::CookWith;
    case Treatment::Burns:
      return ActionType::BurnWith;
    case Treatment::Washes:
      return ActionType::WashWith;
    case Treatment::Soaks:
      return ActionType::SoakWith;
    case Treatment::Fills:
      return ActionType::FillWith;
    default:
      return std::nullopt;
  }
}

void run_processes(const Setting& setting, World& world, Id tool, bool tap_runs) {
  for (std::size_t i = 0; i < world.things.size(); ++i) {
    const auto thing = Id::thing(i);
    if (!world[thing].exists || !rests_on(world, thing, tool)) continue;
    for (const Reaction& reaction : setting.rules->reactions(setting.kind_number(tool), setting.kind_number(thing))) {
      const auto& states = sets(reaction.treatment);
      if (states.empty() || !needs_met(setting, world, reaction, tool, thing, tap_runs)) continue;
      for (const Predicate state : states) world[thing].set(state);
      if (reaction.treatment == Treatment::Fills) world[thing].filling = reaction.symbol;
      if (reaction.treatment == Treatment::Washes) world[thing].coats.clear();
    }
  }
}

Failure treat_with(const Setting& setting, World& world, Id tool, Treatment treatment) {
  if (world.held == kNobody) return Failure::NotHolding;
  const Id item = world.held;
  const Reaction* reaction = setting.rules->reaction(setting.kind_number(tool), treatment, setting.kind_number(item));
  if (reaction == nullptr || (reaction->needs & kHeld) != 0) return Failure::NoEffect;
  if (const Failure blocked = out_of_reach(setting, world, tool); blocked != Failure::None) return blocked;

  World trial = world;
  const bool openable = setting.kind_of(tool).openable;
  const auto closed = [&] { return openable && !trial[tool].has(Predicate::Open); };
  const bool inside = (reaction->needs & (kInside | kUnderTap)) != 0;
  const bool was_closed = closed();
  const bool switches = (reaction->needs & kPowerOn) != 0 && trial[tool].has(Predicate::PowerOff);
  Failure failure = Failure::None;
  const auto run = [&](bool wanted, auto step) {
    if (wanted && failure == Failure::None) failure = step();
  };
  run(inside && was_closed, [&] { return swing(setting, trial, tool, true); });
  const Step put{inside ? ActionType::PlaceIn : ActionType::PlaceOn, tool};
  run(true, [&] { return place(setting, trial, put); });
  run((reaction->needs & kClosed) != 0 && openable, [&] { return swing(setting, trial, tool, false); });
  run(switches, [&] { return switch_power(setting, trial, tool, true); });
  run((reaction->needs & kUnderTap) != 0, [&] {
    run_processes(setting, trial, tool, true);
    return Failure::None;
  });
  run(switches, [&] { return switch_power(setting, trial, tool, false); });
  run(closed(), [&] { return swing(setting, trial, tool, true); });
  run(true, [&] { return pick_up(setting, trial, item); });
  run(was_closed, [&] { return swing(setting, trial, tool, false); });
  if (failure == Failure::None) world = std::move(trial);
  return failure;
}

Failure slice(const Setting& setting, World& world, Id thing) {
  if (world.held == thing) return Failure::InvalidArgument;
  if (!setting.kind_of(thing).sliceable) return Failure::NotSliceable;
  if (world.held == kNobody) return Failure::NoKnife;
  const Reaction* cut = by_hand(setting, world, Treatment::Slices, thing);
  if (cut == nullptr) return Failure::NoKnife;
  if (world[thing].has(Predicate::Sliced)) return Failure::NotSliceable;
  if (const Failure blocked = out_of_reach(setting, world, thing); blocked != Failure::None) return blocked;
  int made = 0;
  for (std::size_t i = 0; i < world.things.size() && made < cut->pieces; ++i) {
    const Role& role = setting.cast.things[i];
    if (role.whole != thing || role.kind != cut->piece) continue;
    Thing piece = world[thing];  // where the whole is, and as it is, but neither whole nor sliced
    piece.clear(Predicate::Whole);
    piece.clear(Predicate::Sliced);
    piece.beside = kNobody;
    world.things[i] = piece;
    ++made;
  }
  if (made == 0) return Failure::NotSliceable;
  world[thing].set(Predicate::Sliced);
  return Failure::None;
}

Failure pour_to(const Setting& setting, World& world, Id target) {
  if (world.held == kNobody) return Failure::NotHolding;
  Thing& vessel = world[world.held];
  if (!vessel.has(Predicate::Filled)) return Failure::VesselEmpty;
  if (world.held == target) return Failure::InvalidArgument;
  if (const Failure blocked = out_of_reach(setting, world, target); blocked != Failure::None) return blocked;
  const bool drains =
      setting.kind_of(target).drain || setting.rules->reaction(setting.kind_number(target), Treatment::Drains,
                                                               setting.kind_number(world.held)) != nullptr;
  if (!drains) {
    if (!setting.kind_of(target).fillable) return Failure::NotFillable;
    if (world[target].has(Predicate::Filled)) return Failure::AlreadyFull;
    world[target].set(Predicate::Filled);
    world[target].filling = vessel.filling;
  }
  vessel.set(Predicate::Empty);
  vessel.filling = {};
  return Failure::None;
}

Failure use_up(const Setting& setting, World& world, Id thing) {
  if (!setting.kind_of(thing).consumable || world[thing].has(Predicate::UsedUp)) return Failure::NotConsumable;
  if (world.held != thing) {
    if (const Failure blocked = out_of_reach(setting, world, thing); blocked != Failure::None) return blocked;
  }
  world[thing].set(Predicate::UsedUp);
  return Failure::None;
}

Failure wipe(const Setting& setting, World& world, Id thing) {
  if (world.held == kNobody) return Failure::NotHolding;
  if (world.held == thing) return Failure::InvalidArgument;
  if (by_hand(setting, world, Treatment::Wipes, thing) == nullptr) return Failure::NoEffect;
  if (const Failure blocked = out_of_reach(setting, world, thing); blocked != Failure::None) return blocked;
  // Dust comes off with a dry cloth; everything else wants a wet one.
  const auto dust = setting.rules->symbol_named("dust");
  if ((world[thing].coats.has_other_than(dust) || world[thing].has(Predicate::Dirty)) &&
      world[world.held].has(Predicate::Dry))
    return Failure::NotReady;
  world[thing].coats.clear();
  if (world[thing].has(Predicate::Dirty)) world[thing].set(Predicate::Clean);
  return Failure::None;
}

Failure spread_to(const Setting& setting, World& world, Id thing) {
  if (world.held == kNobody) return Failure::NotHolding;
  if (world.held == thing) return Failure::InvalidArgument;
  const Reaction* spread = by_hand(setting, world, Treatment::Dispenses, thing);
  if (spread == nullptr) return Failure::NoEffect;
  if (const Failure blocked = out_of_reach(setting, world, thing); blocked != Failure::None) return blocked;
  world[thing].coats.insert(spread->symbol);
  return Failure::None;
}

}  // namespace unietp::symbolic
