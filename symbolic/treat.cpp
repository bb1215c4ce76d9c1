#include "symbolic/perform.h"

// What tools and appliances do, and what is cut: simulation/effects.cpp without geometry.
namespace unietp::symbolic {
namespace {

bool needs_met(const Setting& setting, const World& world, const Reaction& reaction, Id tool, Id thing, bool tap_runs) {
  const auto asks = [&](std::uint8_t need) { return (reaction.needs & need) != 0; };
  if (asks(kHeld)) return false;
  if (asks(kClosed) && setting.kind_of(tool).openable && !world[tool].has(Predicate::Closed)) return false;
  if (asks(kPowerOn) && world[tool].has(Predicate::PowerOff)) return false;
  if (asks(kInside) && !is_inside(world, thing, tool)) return false;
  if (asks(kOn) && !holds(setting, world, Predicate::On, thing, tool, kAnySymbol)) return false;
  return !asks(kUnderTap) || tap_runs || world[tool].has(Predicate::PowerOn);
}

std::optional<AtomicSteps> steps_with(const Setting& setting, const World& world, Id tool, Treatment treatment) {
  const Id item = world.held;
  const Reaction* reaction = setting.rules->reaction(setting.kind_number(tool), treatment, setting.kind_number(item));
  if (reaction == nullptr || (reaction->needs & kHeld) != 0) return std::nullopt;
  const bool openable = setting.kind_of(tool).openable;
  const bool was_closed = openable && !world[tool].has(Predicate::Open);
  const bool inside = (reaction->needs & (kInside | kUnderTap)) != 0;
  const bool closes = openable && (reaction->needs & kClosed) != 0;
  const bool switches = (reaction->needs & kPowerOn) != 0 && world[tool].has(Predicate::PowerOff);
  AtomicSteps steps;
  steps.runs_tap = (reaction->needs & kUnderTap) != 0;
  const auto add = [tool](std::vector<Step>& part, bool wanted, ActionType action) {
    if (wanted) part.push_back({action, tool});
  };
  add(steps.there, inside && was_closed, ActionType::Open);
  add(steps.there, true, inside ? ActionType::PlaceIn : ActionType::PlaceOn);
  add(steps.there, closes, ActionType::Close);
  add(steps.there, switches, ActionType::TurnOn);
  add(steps.back, switches, ActionType::TurnOff);
  add(steps.back, closes || (was_closed && !inside), ActionType::Open);
  steps.back.push_back({ActionType::PickUp, item});
  add(steps.back, was_closed, ActionType::Close);
  return steps;
}

}  // namespace

void run_processes(const Setting& setting, World& world, Id tool, bool tap_runs) {
  for (std::size_t i = 0; i < world.things.size(); ++i) {
    const auto thing = Id::thing(i);
    if (!world[thing].exists || !rests_on(world, thing, tool)) continue;
    for (const Reaction& reaction : setting.rules->reactions(setting.kind_number(tool), setting.kind_number(thing))) {
      const auto states = sets(reaction.treatment);
      if (states.empty() || !needs_met(setting, world, reaction, tool, thing, tap_runs)) continue;
      for (const Predicate state : states) world[thing].set(state);
      if (reaction.treatment == Treatment::Fills) world[thing].filling = reaction.symbol;
      if (reaction.treatment == Treatment::Washes) world[thing].coats.clear();
    }
  }
}

Failure treat_with(const Setting& setting, World& world, Id tool, Treatment treatment, std::vector<World>* passed) {
  const auto steps = steps_with(setting, world, tool, treatment);
  if (!steps) return Failure::NoEffect;
  World trial = world;
  std::vector<World> way;  // the world after each step
  const auto run = [&](const std::vector<Step>& part) {
    for (const Step& step : part) {
      if (const Failure failure = perform_checked(setting, trial, step); failure != Failure::None) return failure;
      if (passed != nullptr) way.push_back(trial);
    }
    return Failure::None;
  };
  if (const Failure failure = run(steps->there); failure != Failure::None) return failure;
  if (steps->runs_tap) {
    run_processes(setting, trial, tool, true);
    if (passed != nullptr) way.push_back(trial);
  }
  if (const Failure failure = run(steps->back); failure != Failure::None) return failure;
  world = std::move(trial);
  if (passed != nullptr) passed->insert(passed->end(), way.begin(), way.end() - 1);
  return Failure::None;
}

std::optional<AtomicSteps> atomic_steps(const Setting& setting, const World& world, const Step& step) {
  if (info(step.action).argument != ActionArgument::Tool) return std::nullopt;
  for (const TreatmentInfo& row : all_treatments()) {
    if (row.treats != step.action) continue;
    if (auto steps = steps_with(setting, world, step.target, row.treatment)) return steps;
  }
  return std::nullopt;
}

Failure slice(const Setting& setting, World& world, Id thing) {
  const Reaction* cut =
      setting.rules->reaction(setting.kind_number(world.held), Treatment::Slices, setting.kind_number(thing));
  int made = 0;
  for (std::size_t i = 0; i < world.things.size() && made < cut->pieces; ++i) {
    const ObjectEntry& role = setting.objects.things[i];
    if (role.whole != thing || role.kind != cut->piece) continue;
    Thing piece = world[thing];  // at the place of the whole, with its states except for `whole` and `sliced`
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

}  // namespace unietp::symbolic
