#include <algorithm>

#include "simulation/world_state.h"

// Actions on contents and substances: pouring, spreading, wiping, using up.
namespace unietp {
namespace {

/// The node in the first hand, or nullopt.
std::optional<std::size_t> in_hand(const WorldState& state) {
  if (state.agent().held.empty()) return std::nullopt;
  return state.index_of(state.agent().held.front());
}

std::optional<std::string> filling_of(const Node& node) {
  for (const State& state : node.states.all()) {
    if (state.predicate == Predicate::Filled) return state.symbol;
  }
  return std::nullopt;
}

std::vector<std::string> coats_of(const Node& node) {
  std::vector<std::string> coats;
  for (const State& state : node.states.all()) {
    if (state.predicate == Predicate::Covered) coats.push_back(state.symbol);
  }
  return coats;
}

/// Dust comes off with a dry cloth; everything else needs a wet one (BEHAVIOR's removers: dust dry, stains with water).
bool is_dust(const std::string& coat) { return coat == "dust"; }

}  // namespace

ActionResult pour_to(WorldState& state, std::size_t target) {
  const auto hand = in_hand(state);
  if (!hand) return failed(FailureCause::HandsEmpty);
  const auto substance = filling_of(state.node(*hand));
  if (!substance) return failed(FailureCause::VesselEmpty, state.reference(*hand));
  if (state.held(state.node(target).id)) return failed(FailureCause::InHand, state.reference(target));
  if (auto blocked = access_failure(state, target)) return *blocked;
  const bool drains =
      state.knowledge->effect(state.node(target).category, Treatment::Drains, state.node(*hand).category) ||
      state.knowledge->has(state.node(target).category, "drain");
  if (!drains) {
    if (!state.knowledge->has(state.node(target).category, "fillable"))
      return failed(FailureCause::NotFillable, state.reference(target));
    if (state.node(target).states.has(Predicate::Filled))
      return failed(FailureCause::AlreadyFull, state.reference(target));
    state.edit_states(target).set({Predicate::Filled, *substance});
  }
  state.edit_states(*hand).set({Predicate::Empty, ""});
  look_at(state, state.node(target).pose.position);
  state.carry_along();
  return succeeded();
}

ActionResult use_up(WorldState& state, std::size_t i) {
  const std::string id = state.node(i).id;
  if (!state.knowledge->has(state.node(i).category, "consumable"))
    return failed(FailureCause::NotConsumable, state.reference(i));
  if (!state.held(id)) {
    if (auto blocked = access_failure(state, i)) return *blocked;
  }
  if (state.node(i).states.has(Predicate::UsedUp)) return failed(FailureCause::AlreadyUsedUp, state.reference(i));
  state.edit_states(i).set({Predicate::UsedUp, ""});
  if (!state.held(id)) {
    look_at(state, state.node(i).pose.position);
    state.carry_along();
  }
  return succeeded();
}

ActionResult wipe(WorldState& state, std::size_t i) {
  const auto hand = in_hand(state);
  if (!hand) return failed(FailureCause::NeedsCloth);
  if (state.held(state.node(i).id)) return failed(FailureCause::MustBePutDown, state.reference(i));
  if (state.knowledge->effect(state.node(*hand).category, Treatment::Wipes, state.node(i).category) == nullptr)
    return failed(FailureCause::CannotBeWiped, state.reference(i), state.reference(*hand));
  if (auto blocked = access_failure(state, i)) return *blocked;
  const auto coats = coats_of(state.node(i));
  const bool stained = state.node(i).states.has(Predicate::Dirty) ||
                       std::any_of(coats.begin(), coats.end(), [](const auto& coat) { return !is_dust(coat); });
  if (stained && state.node(*hand).states.has(Predicate::Dry))
    return failed(FailureCause::ClothDry, state.reference(*hand));
  state.edit_states(i).clear(Predicate::Covered);
  if (state.node(i).states.has(Predicate::Dirty)) state.edit_states(i).set({Predicate::Clean, ""});
  look_at(state, state.node(i).pose.position);
  state.carry_along();
  return succeeded();
}

ActionResult spread_to(WorldState& state, std::size_t i) {
  const auto hand = in_hand(state);
  if (!hand) return failed(FailureCause::NeedsDispenser);
  if (state.held(state.node(i).id)) return failed(FailureCause::MustBePutDown, state.reference(i));
  const Effect* effect =
      state.knowledge->effect(state.node(*hand).category, Treatment::Dispenses, state.node(i).category);
  if (effect == nullptr) return failed(FailureCause::DispensesNothing, state.reference(*hand), state.reference(i));
  if (auto blocked = access_failure(state, i)) return *blocked;
  state.edit_states(i).set({Predicate::Covered, effect->gives});
  look_at(state, state.node(i).pose.position);
  state.carry_along();
  return succeeded();
}

}  // namespace unietp
