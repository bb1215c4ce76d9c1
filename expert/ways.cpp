#include "expert/ways.h"

#include <algorithm>
#include <array>

namespace unietp {
namespace {

constexpr std::array kWays{
    StateWay{Predicate::Open, Way::Direct, ActionType::Open, "openable"},
    StateWay{Predicate::Closed, Way::Direct, ActionType::Close, "openable"},
    StateWay{Predicate::PowerOn, Way::Direct, ActionType::TurnOn, "switchable"},
    StateWay{Predicate::PowerOff, Way::Direct, ActionType::TurnOff, "switchable"},
    StateWay{Predicate::UsedUp, Way::Direct, ActionType::UseUp, "consumable"},
    StateWay{Predicate::Clean, Way::ToolOnHeld, ActionType::WashWith, "washes"},
    StateWay{Predicate::Hot, Way::ToolOnHeld, ActionType::HeatWith, "heats"},
    StateWay{Predicate::Cool, Way::ToolOnHeld, ActionType::CoolWith, "cools"},
    StateWay{Predicate::Frozen, Way::ToolOnHeld, ActionType::CoolWith, "freezes"},
    StateWay{Predicate::Cooked, Way::ToolOnHeld, ActionType::CookWith, "cooks"},
    StateWay{Predicate::Burnt, Way::ToolOnHeld, ActionType::BurnWith, "burns"},
    StateWay{Predicate::Filled, Way::ToolOnHeld, ActionType::FillWith, "fills"},
    StateWay{Predicate::Soaked, Way::ToolOnHeld, ActionType::SoakWith, "soaks"},
    StateWay{Predicate::Empty, Way::ToolOnHeld, ActionType::PourTo, "drains"},
    StateWay{Predicate::Sliced, Way::HeldToolOn, ActionType::Slice, "slices"},
    StateWay{Predicate::Clean, Way::HeldToolOn, ActionType::Wipe, "wipes"},
    StateWay{Predicate::Filled, Way::HeldToolOn, ActionType::PourTo, "fills"},
    StateWay{Predicate::Covered, Way::HeldToolOn, ActionType::SpreadTo, "dispenses"},
    StateWay{Predicate::SatOn, Way::Direct, ActionType::SitOn, "sittable"},
    StateWay{Predicate::LainOn, Way::Direct, ActionType::LieOn, "lieable"},
    StateWay{Predicate::PluggedIn, Way::Direct, ActionType::PlugIn, "pluggable"},
    StateWay{Predicate::Unplugged, Way::Direct, ActionType::Unplug, "pluggable"},
    StateWay{Predicate::Folded, Way::Direct, ActionType::Fold, "foldable"},
    StateWay{Predicate::Broken, Way::Direct, ActionType::Break, "breakable"},
    StateWay{Predicate::Hot, Way::Appliance, ActionType::PlaceIn, "heats"},
    StateWay{Predicate::Cool, Way::Appliance, ActionType::PlaceIn, "cools"},
    StateWay{Predicate::Frozen, Way::Appliance, ActionType::PlaceIn, "freezes"},
    StateWay{Predicate::Cooked, Way::Appliance, ActionType::PlaceIn, "cooks"},
    StateWay{Predicate::Burnt, Way::Appliance, ActionType::PlaceIn, "burns"},
    StateWay{Predicate::Clean, Way::Appliance, ActionType::PlaceIn, "washes"},
    StateWay{Predicate::Filled, Way::Appliance, ActionType::PlaceIn, "fills"},
    StateWay{Predicate::Filled, Way::FromVessel, ActionType::PourTo, "fillable"},
};

/// What covers a thing comes off, whatever it is.
constexpr StateWay kWipeOff{Predicate::Covered, Way::HeldToolOn, ActionType::Wipe, "wipes"};

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
      if (situation.knowledge->has(category, way.needs)) return true;
      continue;
    }
    if (way.way == Way::FromVessel) {
      if (situation.knowledge->has(category, way.needs) && some_vessel(literal, situation)) return true;
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
  for (const StateWay& way : kWays) {
    if (way.predicate == predicate && profile.offers(way.action)) ways.push_back(way);
  }
  return ways;
}

std::vector<const Effect*> rules_for(const StateWay& way, std::string_view category, std::string_view symbol,
                                     const NodeIndex& places, const Knowledge& knowledge) {
  std::vector<const Effect*> rules;
  for (const Effect* effect : knowledge.effects_on(category, way.needs)) {
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
  return std::any_of(kWays.begin(), kWays.end(), [predicate](const StateWay& way) {
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
