#include "expert/achievers.h"

#include <algorithm>
#include <array>

#include "scene/action_table.h"
#include "scene/treatment.h"

namespace unietp {
namespace {

/// What a held tool does to an object, and pouring; the other ways come from the tables of actions and treatments.
constexpr std::array kByHand{
    Achiever{Predicate::Empty, AchieverKind::ToolOnHeld, ActionType::PourTo, "", Treatment::Drains},
    Achiever{Predicate::Sliced, AchieverKind::HeldToolOn, ActionType::Slice, "", Treatment::Slices},
    Achiever{Predicate::Clean, AchieverKind::HeldToolOn, ActionType::Wipe, "", Treatment::Wipes},
    Achiever{Predicate::Filled, AchieverKind::HeldToolOn, ActionType::PourTo, "", Treatment::Fills},
    Achiever{Predicate::Covered, AchieverKind::HeldToolOn, ActionType::SpreadTo, "", Treatment::Dispenses},
};
constexpr Achiever kFromVessel{Predicate::Filled, AchieverKind::FromVessel, ActionType::PourTo, "fillable"};

/// All ways, for each state the best first.
const std::vector<Achiever>& all_achievers() {
  static const auto ways = [] {
    std::vector<Achiever> all;
    for (const ActionInfo& action : action_table()) {
      if (!action.direct) continue;
      all.push_back({action.changes.front().state, AchieverKind::Direct, action.type, affordance_for(action)});
    }
    for (const TreatmentInfo& row : all_treatments()) {
      if (row.treats) all.push_back({row.states.front(), AchieverKind::ToolOnHeld, *row.treats, "", row.treatment});
    }
    all.insert(all.end(), kByHand.begin(), kByHand.end());
    for (const TreatmentInfo& row : all_treatments()) {
      const bool appliance = row.treats && info(*row.treats).group == ActionClass::Composite;
      if (appliance)
        all.push_back({row.states.front(), AchieverKind::Appliance, ActionType::PlaceIn, "", row.treatment});
    }
    all.push_back(kFromVessel);
    return all;
  }();
  return ways;
}

/// What covers a thing comes off, whatever it is.
constexpr Achiever kWipeOff{Predicate::Covered, AchieverKind::HeldToolOn, ActionType::Wipe, "", Treatment::Wipes};

/// Something that can be poured from is filled so already, or can be.
bool some_vessel(const Literal& literal, const Situation& situation) {
  const auto& nodes = situation.start->nodes;
  return std::any_of(nodes.begin(), nodes.end(), [&](const Node& node) {
    if (&node == situation.node(literal.subject) || !node.movable) return false;
    if (!situation.knowledge->has(node.category, "fillable")) return false;
    if (node.states.has({Predicate::Filled, literal.symbol})) return true;
    const auto ways = achievers_of(Predicate::Filled, situation.profile);
    return std::any_of(ways.begin(), ways.end(), [&](const Achiever& achiever) {
      return achiever.kind != AchieverKind::FromVessel &&
             !rules_for(achiever, node.category, literal.symbol, situation.places(), *situation.knowledge).empty();
    });
  });
}

bool state_achievable(const Literal& literal, const Situation& situation) {
  const Node* node = situation.node(literal.subject);
  if (node == nullptr) return false;
  const std::string& category = situation.entity(literal.subject).category;
  for (const Achiever& achiever : achievers_of(literal.predicate, situation.profile)) {
    if (achiever.kind == AchieverKind::Direct) {
      if (situation.knowledge->has(category, achiever.affordance)) return true;
      continue;
    }
    if (achiever.kind == AchieverKind::FromVessel) {
      if (situation.knowledge->has(category, achiever.affordance) && some_vessel(literal, situation)) return true;
      continue;
    }
    const bool in_hand = achiever.kind == AchieverKind::ToolOnHeld || achiever.kind == AchieverKind::Appliance;
    if (in_hand && !node->movable) continue;
    if (!rules_for(achiever, category, literal.symbol, situation.places(), *situation.knowledge).empty()) return true;
  }
  return false;
}

}  // namespace

std::vector<Achiever> achievers_of(Predicate predicate, const Profile& profile) {
  std::vector<Achiever> ways;
  for (const Achiever& achiever : all_achievers()) {
    if (achiever.predicate == predicate && profile.offers(achiever.action)) ways.push_back(achiever);
  }
  return ways;
}

std::vector<const Effect*> rules_for(const Achiever& achiever, std::string_view category, std::string_view symbol,
                                     const NodeIndex& places, const Knowledge& knowledge) {
  std::vector<const Effect*> rules;
  for (const Effect* effect : knowledge.effects_on(category, *achiever.treatment)) {
    if (!symbol.empty() && symbol != "any" && effect->gives != symbol) continue;
    if (!places.of(effect->tool).empty()) rules.push_back(effect);
  }
  return rules;
}

bool is_placement(Predicate predicate) {
  switch (predicate) {
    case Predicate::On:
    case Predicate::Inside:
    case Predicate::OnFloor:
    case Predicate::InRoom:
    case Predicate::NextTo:
    case Predicate::Attached:
      return true;
    default:
      return false;
  }
}

bool changes_in_hand(Predicate predicate) {
  return std::any_of(all_achievers().begin(), all_achievers().end(), [predicate](const Achiever& achiever) {
    return achiever.predicate == predicate && achiever.kind == AchieverKind::ToolOnHeld;
  });
}

bool achievable(const Literal& literal, const Situation& situation) {
  if (literal.subject == literal.object) return false;
  const Node* node = situation.node(literal.subject);
  if (literal.predicate == Predicate::InRoom && literal.positive &&
      situation.entity(literal.subject).kind == Entity::Kind::Agent) {
    return true;
  }
  if (is_placement(literal.predicate) || literal.predicate == Predicate::Held) {
    return node != nullptr && (node->movable || situation.is_imagined(literal.subject));
  }
  if (literal.positive) return state_achievable(literal, situation);
  return literal.predicate == Predicate::Covered && node != nullptr && situation.profile.offers(kWipeOff.action) &&
         !rules_for(kWipeOff, situation.entity(literal.subject).category, "", situation.places(), *situation.knowledge)
              .empty();
}

}  // namespace unietp
