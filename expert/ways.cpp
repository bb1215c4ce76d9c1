#include "expert/ways.h"

#include <algorithm>
#include <array>

#include "scene/action_table.h"
#include "scene/treatment.h"

namespace unietp {
namespace {

/// What a held tool does to an object, and pouring; the other ways come from the tables of actions and treatments.
constexpr std::array kByHand{
    StateWay{Predicate::Empty, Way::ToolOnHeld, ActionType::PourTo, "", Treatment::Drains},
    StateWay{Predicate::Sliced, Way::HeldToolOn, ActionType::Slice, "", Treatment::Slices},
    StateWay{Predicate::Clean, Way::HeldToolOn, ActionType::Wipe, "", Treatment::Wipes},
    StateWay{Predicate::Filled, Way::HeldToolOn, ActionType::PourTo, "", Treatment::Fills},
    StateWay{Predicate::Covered, Way::HeldToolOn, ActionType::SpreadTo, "", Treatment::Dispenses},
};
constexpr StateWay kFromVessel{Predicate::Filled, Way::FromVessel, ActionType::PourTo, "fillable"};

/// All ways, for each state the best first.
const std::vector<StateWay>& all_ways() {
  static const auto ways = [] {
    std::vector<StateWay> all;
    for (const ActionInfo& action : action_table()) {
      if (action.changes.empty()) continue;
      all.push_back({action.changes.front().state, Way::Direct, action.type, affordance_for(action)});
    }
    for (const TreatmentInfo& row : all_treatments()) {
      if (row.treats) all.push_back({row.states.front(), Way::ToolOnHeld, *row.treats, "", row.treatment});
    }
    all.insert(all.end(), kByHand.begin(), kByHand.end());
    for (const TreatmentInfo& row : all_treatments()) {
      const bool appliance = row.treats && info(*row.treats).group == ActionClass::Composite;
      if (appliance) all.push_back({row.states.front(), Way::Appliance, ActionType::PlaceIn, "", row.treatment});
    }
    all.push_back(kFromVessel);
    return all;
  }();
  return ways;
}

/// What covers a thing comes off, whatever it is.
constexpr StateWay kWipeOff{Predicate::Covered, Way::HeldToolOn, ActionType::Wipe, "", Treatment::Wipes};

/// Something that can be poured from is filled so already, or can be.
bool some_vessel(const Literal& literal, const Situation& situation) {
  const auto& nodes = situation.start->nodes;
  return std::any_of(nodes.begin(), nodes.end(), [&](const Node& node) {
    if (&node == situation.node(literal.subject) || !node.movable) return false;
    if (!situation.knowledge->has(node.category, "fillable")) return false;
    if (node.states.has({Predicate::Filled, literal.symbol})) return true;
    const auto ways = ways_to(Predicate::Filled, situation.profile);
    return std::any_of(ways.begin(), ways.end(), [&](const StateWay& way) {
      return way.way != Way::FromVessel &&
             !rules_for(way, node.category, literal.symbol, situation.places(), *situation.knowledge).empty();
    });
  });
}

bool state_achievable(const Literal& literal, const Situation& situation) {
  const Node* node = situation.node(literal.subject);
  if (node == nullptr) return false;
  const std::string& category = situation.entity(literal.subject).category;
  for (const StateWay& way : ways_to(literal.predicate, situation.profile)) {
    if (way.way == Way::Direct) {
      if (situation.knowledge->has(category, way.affordance)) return true;
      continue;
    }
    if (way.way == Way::FromVessel) {
      if (situation.knowledge->has(category, way.affordance) && some_vessel(literal, situation)) return true;
      continue;
    }
    const bool in_hand = way.way == Way::ToolOnHeld || way.way == Way::Appliance;
    if (in_hand && !node->movable) continue;
    if (!rules_for(way, category, literal.symbol, situation.places(), *situation.knowledge).empty()) return true;
  }
  return false;
}

}  // namespace

std::vector<StateWay> ways_to(Predicate predicate, const Profile& profile) {
  std::vector<StateWay> ways;
  for (const StateWay& way : all_ways()) {
    if (way.predicate == predicate && profile.offers(way.action)) ways.push_back(way);
  }
  return ways;
}

std::vector<const Effect*> rules_for(const StateWay& way, std::string_view category, std::string_view symbol,
                                     const NodeIndex& places, const Knowledge& knowledge) {
  std::vector<const Effect*> rules;
  for (const Effect* effect : knowledge.effects_on(category, *way.treatment)) {
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
  return std::any_of(all_ways().begin(), all_ways().end(), [predicate](const StateWay& way) {
    return way.predicate == predicate && way.way == Way::ToolOnHeld;
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
