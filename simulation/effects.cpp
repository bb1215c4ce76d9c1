#include <algorithm>
#include <array>

#include "scene/fresh_id.h"
#include "simulation/world_state.h"

namespace unietp {
namespace {

/// The states that an effect of the knowledge base gives its target.
struct Rule {
  Treatment treatment;
  std::vector<Predicate> sets;
};

const std::array<Rule, 8>& rules() {
  static const std::array<Rule, 8> kRules{{
      {Treatment::Heats, {Predicate::Hot}},
      {Treatment::Cools, {Predicate::Cool}},
      {Treatment::Freezes, {Predicate::Frozen, Predicate::Cool}},
      {Treatment::Cooks, {Predicate::Cooked, Predicate::Hot}},
      {Treatment::Burns, {Predicate::Burnt, Predicate::Hot}},
      {Treatment::Washes, {Predicate::Clean}},
      {Treatment::Soaks, {Predicate::Soaked}},
      {Treatment::Fills, {Predicate::Filled}},
  }};
  return kRules;
}

bool offered(const Profile& profile, Treatment treatment) {
  if (treatment == Treatment::Washes || treatment == Treatment::Fills || treatment == Treatment::Soaks)
    return profile.washing;
  if (treatment == Treatment::Slices) return profile.slicing;
  return profile.temperature;
}

bool is_met(EffectNeed need, const WorldState& state, std::size_t tool_at, std::size_t target, bool tap_runs) {
  const Node& tool = state.node(tool_at);
  switch (need) {
    case EffectNeed::Closed:
      return !tool.openable || tool.states.has(Predicate::Closed);
    case EffectNeed::PowerOn:
      return !tool.states.has(Predicate::PowerOff);
    case EffectNeed::Held:
      return state.held(tool.id);
    case EffectNeed::Inside:
      return state.linked(target, Predicate::Inside, tool_at);
    case EffectNeed::On:
      return state.linked(target, Predicate::On, tool_at);
    case EffectNeed::UnderTap:
      return tap_runs || tool.states.has(Predicate::PowerOn);
  }
  return false;
}

bool needs_met(const WorldState& state, const Effect& effect, std::size_t tool, std::size_t target, bool tap_runs) {
  return std::all_of(effect.needs.begin(), effect.needs.end(),
                     [&](EffectNeed need) { return is_met(need, state, tool, target, tap_runs); });
}

/// Runs the steps of a composite action up to the first failure.
class Steps {
 public:
  Steps(FailureReference tool, const PassesThrough& passes) : tool_(std::move(tool)), passes_(passes) {}
  template <class Step>
  void run(Step step) {
    if (!result_.success) return;
    if (begun_) passes_();
    begun_ = true;
    result_ = step();
  }
  ActionResult result() const {
    ActionResult result = result_;
    if (!result.success) result.detail.tool = tool_;
    return result;
  }

 private:
  FailureReference tool_;
  const PassesThrough& passes_;
  bool begun_ = false;
  ActionResult result_ = succeeded();
};

}  // namespace

void run_processes(WorldState& state, std::size_t tool, bool tap_runs) {
  for (const std::size_t target : state.group_of(tool)) {
    if (target == tool) continue;
    for (const Rule& rule : rules()) {
      const Effect* effect =
          state.knowledge->effect(state.node(tool).category, rule.treatment, state.node(target).category);
      if (effect == nullptr || !offered(*state.profile, rule.treatment) || has_need(*effect, EffectNeed::Held))
        continue;
      if (!needs_met(state, *effect, tool, target, tap_runs)) continue;
      StateSet& states = state.edit_states(target);
      for (const Predicate predicate : rule.sets) {
        states.set({predicate, predicate == Predicate::Filled ? effect->gives : ""});
      }
      if (rule.treatment == Treatment::Washes) states.clear(Predicate::Covered);
    }
  }
}

ActionResult switch_power(WorldState& state, std::size_t i, bool on) {
  const Node& node = state.node(i);
  if (!node.states.has(Predicate::PowerOn) && !node.states.has(Predicate::PowerOff)) {
    return failed(FailureCause::NotSwitchable, state.reference(i));
  }
  if (!state.held(node.id)) {
    if (auto blocked = access_failure(state, i)) return *blocked;
  }
  if (on && node.states.has(Predicate::PowerOn)) return failed(FailureCause::AlreadyOn, state.reference(i));
  if (!on && node.states.has(Predicate::PowerOff)) return failed(FailureCause::AlreadyOff, state.reference(i));
  if (on && state.profile->power_needs_closed && node.openable && node.archetype == Archetype::Cabinet &&
      node.states.has(Predicate::Open)) {
    return failed(FailureCause::MustBeClosed, state.reference(i));
  }
  if (on && state.profile->power_needs_plug && node.states.has(Predicate::Unplugged))
    return failed(FailureCause::NotPluggedIn, state.reference(i));
  state.edit_states(i).set({on ? Predicate::PowerOn : Predicate::PowerOff, ""});
  if (!state.held(node.id)) {
    look_at(state, node.pose.position);
    state.carry_along();
  }
  run_processes(state, i);
  return succeeded();
}

ActionResult treat_with(WorldState& state, std::size_t tool, Treatment treatment, const PassesThrough& passes) {
  if (state.agent().held.empty()) return failed(FailureCause::HandsEmpty);
  const std::size_t item = *state.index_of(state.agent().held.front());
  const Effect* effect = state.knowledge->effect(state.node(tool).category, treatment, state.node(item).category);
  // Effects of a held tool (a bottle that pours) belong to other actions.
  if (effect == nullptr || !offered(*state.profile, treatment) || has_need(*effect, EffectNeed::Held)) {
    return failed(FailureCause::ToolHasNoEffect, state.reference(item), state.reference(tool));
  }
  if (auto blocked = access_failure(state, tool)) return *blocked;

  const auto closed = [&] { return state.node(tool).openable && !state.node(tool).states.has(Predicate::Open); };
  const bool inside = has_need(*effect, EffectNeed::Inside) || has_need(*effect, EffectNeed::UnderTap);
  const bool was_closed = closed();
  const bool switches = has_need(*effect, EffectNeed::PowerOn) && state.node(tool).states.has(Predicate::PowerOff);
  Steps steps(state.reference(tool), passes);
  if (inside && was_closed) steps.run([&] { return swing(state, tool, true); });
  steps.run([&] { return place(state, tool, inside, true); });
  if (has_need(*effect, EffectNeed::Closed) && state.node(tool).openable)
    steps.run([&] { return swing(state, tool, false); });
  if (switches) steps.run([&] { return switch_power(state, tool, true); });
  if (has_need(*effect, EffectNeed::UnderTap)) {
    steps.run([&] {
      run_processes(state, tool, true);
      return succeeded();
    });
  }
  if (switches) steps.run([&] { return switch_power(state, tool, false); });
  steps.run([&] { return closed() ? swing(state, tool, true) : succeeded(); });
  steps.run([&] { return pick_up(state, item); });
  if (was_closed) steps.run([&] { return swing(state, tool, false); });
  return steps.result();
}

ActionResult slice(WorldState& state, std::size_t i) {
  const auto in_hand = state.in_hand();  // with what lies on or in a thing that is held
  if (std::binary_search(in_hand.begin(), in_hand.end(), i))
    return failed(FailureCause::MustBePutDown, state.reference(i));
  if (!state.profile->slicing || !state.knowledge->has(state.node(i).category, "sliceable")) {
    return failed(FailureCause::NotSliceable, state.reference(i));
  }
  if (state.agent().held.empty()) return failed(FailureCause::NeedsKnife);
  const std::size_t knife = *state.index_of(state.agent().held.front());
  const Effect* effect = state.knowledge->effect(state.node(knife).category, Treatment::Slices, state.node(i).category);
  if (effect == nullptr) return failed(FailureCause::DoesNotSlice, state.reference(knife), state.reference(i));
  if (state.node(i).states.has(Predicate::Sliced)) return failed(FailureCause::AlreadySliced, state.reference(i));
  if (auto blocked = access_failure(state, i)) return *blocked;
  const Category* piece = state.knowledge->find(effect->gives);
  if (piece == nullptr) return failed(FailureCause::NotSliceable, state.reference(i));

  // Cut along the longest horizontal side into equal pieces. The first keeps the id of the whole, so that a goal can
  // still refer to it; the others are new. Together they fill the space of the whole, less the width of the blade.
  constexpr double kBlade_m = 0.001;
  const int pieces = std::max(2, effect->amount);
  const Node whole = state.node(i);
  const int axis = whole.size.x() >= whole.size.y() ? 0 : 1;
  const double length = whole.size[axis];
  Vec3 size = whole.size;
  size[axis] = length / pieces - kBlade_m;
  std::vector<BodyId> loose;
  for (int k = 0; k < pieces; ++k) {
    Vec3 offset = Vec3::Zero();
    offset[axis] = -length / 2 + (k + 0.5) * length / pieces;
    Node part = whole;
    part.pose = whole.pose * Pose{offset, Quat::Identity()};
    part.size = size;
    part.mass = whole.mass / pieces;
    part.archetype = Archetype::Box;
    part.boards.clear();
    std::size_t index = i;
    if (k == 0) {
      part.states.set({Predicate::Sliced, ""});
      state.replace(i, part);
    } else {
      part.id = fresh_id(state.scene(), state.places(), piece->name);
      part.category = piece->name;
      part.slice_of = whole.id;
      part.whole_category = whole.category;
      part.states.clear(Predicate::Whole);
      part.states.clear(Predicate::Sliced);
      index = state.add(part);
    }
    loose.push_back(BodyId::node(index));
  }
  const Settled settled = state.physics().settle(loose);
  const Bounds whole_bounds = bounds_of(whole.pose, whole.size);
  std::vector<Bounds> touched{whole_bounds};
  for (const SettledBody& body : settled.bodies) {
    state.move(body.body.index(), body.pose);
    touched.push_back(state.physics().bounds(body.body));
  }
  look_at(state, state.node(i).pose.position);
  state.carry_along();
  const std::vector<std::size_t> changed = nodes_of(loose);
  state.refresh(touched, changed);
  return succeeded();
}

}  // namespace unietp
