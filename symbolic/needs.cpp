#include <algorithm>

#include "symbolic/perform.h"

// The needs of scene/action_table.h on symbols.
namespace unietp::symbolic {
namespace {

bool has_one_of_group(const Thing& thing, Predicate state) {
  const auto other = opposite_of(state);
  return thing.has(state) || (other && thing.has(*other));
}

bool carries_something(const World& world, Id thing) {
  return std::any_of(world.things.begin(), world.things.end(), [&](const Thing& other) {
    return other.exists && other.at == thing && (other.where == PlaceKind::On || other.where == PlaceKind::Inside);
  });
}

/// Whether a tool has an effect on a thing that belongs to this action. An effect that needs the tool in the hand
/// belongs to the actions by hand.
bool has_effect(const Setting& setting, Id tool, ActionType action, Id thing) {
  const auto& reactions = setting.rules->reactions(setting.kind_number(tool), setting.kind_number(thing));
  return std::any_of(reactions.begin(), reactions.end(), [action](const Reaction& reaction) {
    const TreatmentInfo& row = info(reaction.treatment);
    return row.by_hand == action || (row.treats == action && (reaction.needs & kHeld) == 0);
  });
}

/// The failure of the need, or None when it is met.
Failure check(const Setting& setting, const World& world, const Step& step, const ActionNeed& need) {
  using Kind = ActionNeed::Kind;
  const Id target = step.target;
  const auto unless = [&need](bool met) { return met ? Failure::None : need.failure; };
  switch (need.kind) {
    case Kind::Affordance:
      return unless(need.affordance == "pickupable" ? setting.kind_of(target).pickupable
                                                    : setting.kind_of(target).allows(step.action));
    case Kind::Varies:
      return unless(has_one_of_group(world[target], need.state));
    case Kind::Is:
      return unless(world[target].has(need.state));
    case Kind::IsNot:
      return unless(!world[target].has(need.state));
    case Kind::NotInHand:
      return unless(world.held != target);
    case Kind::NotCarried:
      return unless(world.held != target && !rests_on(world, target, world.held));
    case Kind::InHand:
      return unless(world.held == target);
    case Kind::HandFree:
      return unless(world.held == kNobody);
    case Kind::Holding:
      return unless(world.held != kNobody);
    case Kind::HeldIs:
      return unless(world[world.held].has(need.state));
    case Kind::HeldIsNot:
      return unless(!world[world.held].has(need.state));
    case Kind::Fits:
      return unless(setting.rules->capacity(setting.kind_number(world.held), need.state, setting.kind_number(target)) >
                    0);
    case Kind::HeldTool:
      return unless(has_effect(setting, world.held, step.action, target));
    case Kind::TargetTool:
      return unless(has_effect(setting, target, step.action, world.held));
    case Kind::ReachOrInHand:
      return world.held == target ? Failure::None : out_of_reach(setting, world, target);
    case Kind::Reach:
    case Kind::Sight:
      return out_of_reach(setting, world, target);
    case Kind::Unloaded:
      return unless(!carries_something(world, target));
    case Kind::Standing:
      return unless(world.seat == kNobody);
    case Kind::Seated:
      return unless(world.seat != kNobody);
    case Kind::NotSeat:
      return unless(world.seat != target);
    case Kind::Special:
      return Failure::None;
  }
  return Failure::None;
}

}  // namespace

bool applies(const Setting& setting, const World& world, ActionRule rule, Id target) {
  const Capabilities& capabilities = setting.rules->capabilities();
  switch (rule) {
    case ActionRule::Always:
      return true;
    case ActionRule::OpenNeedsPowerOff:
      return capabilities.open_needs_power_off;
    case ActionRule::PowerNeedsClosed:
      return capabilities.power_needs_closed && setting.kind_of(target).shuts_to_run;
    case ActionRule::PowerNeedsPlug:
      return capabilities.power_needs_plug;
    case ActionRule::TargetFills:
      return !setting.kind_of(target).drain && setting.rules->reaction(setting.kind_number(target), Treatment::Drains,
                                                                       setting.kind_number(world.held)) == nullptr;
    case ActionRule::TargetStained:  // dust comes off with a dry cloth
      return world[target].has(Predicate::Dirty) ||
             world[target].coats.has_other_than(setting.rules->symbol_named("dust"));
  }
  return true;
}

Failure first_unmet(const Setting& setting, const World& world, const Step& step) {
  for (const ActionNeed& need : info(step.action).needs) {
    if (!applies(setting, world, need.rule, step.target)) continue;
    if (const Failure failure = check(setting, world, step, need); failure != Failure::None) return failure;
  }
  return Failure::None;
}

}  // namespace unietp::symbolic
