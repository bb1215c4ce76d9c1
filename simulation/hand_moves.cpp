#include <algorithm>
#include <numbers>

#include "simulation/world_state.h"

// Actions of the hand with a held object: moving and turning it.
namespace unietp {
namespace {

constexpr double kHandStep_m = 0.2, kHandTurn_deg = 30;  // as the paper's released runner moves it in AI2-THOR
constexpr double kNearest_m = 0.25, kFarthest_m = 0.85, kMostAside_m = 0.4;

/// The failure when a held object overlaps something, or nullopt.
std::optional<ActionResult> held_collision(const WorldState& state) {
  for (const std::string& id : state.agent().held) {
    const auto held = state.index_of(id);
    for (const std::size_t member : state.group_of(*held)) {
      const auto hit = state.physics().overlap(state.collider(member), state.node(member).pose, {});
      if (hit) return failed(FailureCause::HeldWouldHit, state.reference(*held), state.reference_to_body(*hit));
    }
  }
  return std::nullopt;
}

ActionResult with_hand(WorldState& state, const HandPose& hand) {
  if (state.agent().held.empty()) return failed(FailureCause::HandsEmpty);
  const bool in_reach = hand.ahead_m >= kNearest_m - 1e-9 && hand.ahead_m <= kFarthest_m + 1e-9 &&
                        std::abs(hand.left_m) <= kMostAside_m + 1e-9;
  if (!in_reach) return failed(FailureCause::ArmAtLimit);
  state.set_hand(hand);
  state.carry_along();
  if (auto blocked = held_collision(state)) return *blocked;
  return succeeded();
}

}  // namespace

ActionResult move_hand(WorldState& state, double ahead, double left) {
  HandPose hand = state.hand();
  hand.ahead_m += ahead * kHandStep_m;
  hand.left_m += left * kHandStep_m;
  return with_hand(state, hand);
}

ActionResult rotate_hand(WorldState& state) {
  HandPose hand = state.hand();
  hand.turn = std::remainder(hand.turn + kHandTurn_deg * std::numbers::pi / 180, 2 * std::numbers::pi);
  return with_hand(state, hand);
}

}  // namespace unietp
