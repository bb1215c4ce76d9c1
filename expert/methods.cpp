#include "expert/methods.h"

#include <algorithm>
#include <tuple>

#include "expert/ways.h"

namespace unietp {
namespace {

constexpr std::size_t kMostTools = 4;  // tools tried for one change
constexpr std::size_t kMostSpots = 5;  // places tried for putting something aside

/// Failures that may not happen from another place to stand.
bool depends_on_standing(Failure failure) {
  switch (failure) {
    case Failure::TooFar:
    case Failure::NotVisible:
    case Failure::Blocked:
    case Failure::NoFreePlace:
    case Failure::DidNotRest:
      return true;
    default:
      return false;
  }
}

/// The simulator does not offer the action at all, so no other tool helps.
bool not_run_here(const std::optional<Attempt::Trouble>& trouble) {
  return !trouble || trouble->failure == Failure::NotOffered;
}

}  // namespace

const Node* Methods::find(const std::string& id) const { return attempt_.world().find(id); }

bool Methods::is(const std::string& id, Predicate state) const {
  const Node* node = find(id);
  return node != nullptr && node->states.has(state);
}

bool Methods::achieve(const Literal& literal) {
  if (attempt_.holds(literal)) return true;
  const std::string id = attempt_.id_of(literal.subject);
  if (id.empty()) return false;
  bool done = false;
  if (literal.predicate == Predicate::Held) {
    done = literal.positive ? hold(id) : put_aside(id);
  } else if (is_placement(literal.predicate)) {
    done = literal.positive ? place(literal) : take_away(literal);
  } else {
    done = literal.positive ? change_state(literal) : wipe_off(literal);
  }
  return done && attempt_.holds(literal);
}

bool Methods::wipe_off(const Literal& literal) {
  Literal whatever = literal;
  whatever.symbol.clear();
  return literal.predicate == Predicate::Covered && with_held_tool(whatever, ActionType::Wipe, "wipes");
}

bool Methods::change_state(const Literal& literal) {
  const std::string id = attempt_.id_of(literal.subject);
  for (const StateWay& way : ways_to(literal.predicate, attempt_.situation().profile)) {
    bool done = false;
    switch (way.way) {
      case Way::Direct:
        done = device(way.action, id);
        break;
      case Way::ToolOnHeld:
        done = with_tool_on_held(literal, way.action, way.needs);
        break;
      case Way::HeldToolOn:
        done = with_held_tool(literal, way.action, way.needs);
        break;
      case Way::Appliance:
        done = in_appliance(literal, way.needs);
        break;
    }
    if (done && attempt_.holds(literal)) return true;
  }
  return false;
}

std::vector<std::string> Methods::nearest_of(const std::vector<const Effect*>& rules, const std::string& except) const {
  std::vector<std::tuple<bool, double, std::string>> found;
  for (const Node& node : attempt_.world().nodes()) {
    const bool fits =
        std::any_of(rules.begin(), rules.end(), [&node](const Effect* rule) { return rule->tool == node.category; });
    if (!fits || node.id == except) continue;
    const bool held = attempt_.is_held(node.id);
    found.emplace_back(!held, held ? 0.0 : attempt_.world().walking_distance(node.id), node.id);
  }
  std::sort(found.begin(), found.end());
  std::vector<std::string> ids;
  for (const auto& entry : found) {
    if (ids.size() < kMostTools) ids.push_back(std::get<2>(entry));
  }
  return ids;
}

bool Methods::with_held_tool(const Literal& literal, ActionType action, std::string_view effect) {
  const std::string id = attempt_.id_of(literal.subject);
  const StateWay way{literal.predicate, Way::HeldToolOn, action, effect};
  const Node* node = find(id);
  const auto rules = node == nullptr ? std::vector<const Effect*>()
                                     : rules_for(way, node->category, literal.symbol, attempt_.world().nodes(),
                                                 *attempt_.situation().knowledge);
  if (rules.empty()) return false;
  if (attempt_.is_held(id) && !put_aside(id)) return false;
  for (const std::string& tool : nearest_of(rules, id)) {
    if (!hold(tool)) continue;
    if (do_at(action, id)) return true;
    if (attempt_.exhausted() || not_run_here(attempt_.trouble())) return false;
    if (attempt_.trouble()->failure == Failure::NotReady) continue;  // a dry cloth; another may be wet
    if (attempt_.trouble()->failure == Failure::AlreadyFull && pour_away(literal.subject) && hold(tool)) {
      if (do_at(action, id)) return true;
      continue;
    }
    // Not where it lies now: bring it into the open and come back with the tool.
    if (find(id) != nullptr && find(id)->movable && hold(id) && put_aside(id) && hold(tool) && do_at(action, id)) {
      return true;
    }
  }
  return false;
}

/// Of something else: what was washed under a tap is full of water.
bool Methods::pour_away(EntityIndex vessel) {
  Literal empty;
  empty.predicate = Predicate::Empty;
  empty.subject = vessel;
  return change_state(empty) && put_aside(attempt_.id_of(vessel));
}

bool Methods::with_tool_on_held(const Literal& literal, ActionType action, std::string_view effect) {
  const std::string id = attempt_.id_of(literal.subject);
  const StateWay way{literal.predicate, Way::ToolOnHeld, action, effect};
  const Node* node = find(id);
  if (node == nullptr) return false;
  const auto rules =
      rules_for(way, node->category, literal.symbol, attempt_.world().nodes(), *attempt_.situation().knowledge);
  if (rules.empty() || !hold(id)) return false;
  for (const std::string& tool : nearest_of(rules, id)) {
    if (do_at(action, tool)) return true;
    const auto& trouble = attempt_.trouble();
    if (attempt_.exhausted() || not_run_here(trouble)) return false;
    if (trouble->failure == Failure::MustBeClosed && is(tool, Predicate::Open)) {
      if (device(ActionType::Close, tool) && do_at(action, tool)) return true;
    } else if (is(tool, Predicate::Closed)) {
      // With the door open, one stands elsewhere and sees what one lets go of.
      if (device(ActionType::Open, tool) && attempt_.act(ActionType::GoTo, tool) && attempt_.act(action, tool))
        return true;
    }
  }
  return false;
}

/// What the tool does by itself: into it (or on it), door shut, power or water on. The object stays there.
bool Methods::in_appliance(const Literal& literal, std::string_view effect) {
  const std::string id = attempt_.id_of(literal.subject);
  const Node* node = find(id);
  if (node == nullptr || !node->movable) return false;
  const StateWay way{literal.predicate, Way::Appliance, ActionType::PlaceIn, effect};
  for (const Effect* rule :
       rules_for(way, node->category, literal.symbol, attempt_.world().nodes(), *attempt_.situation().knowledge)) {
    const auto needs = [rule](std::string_view need) {
      return std::find(rule->needs.begin(), rule->needs.end(), need) != rule->needs.end();
    };
    if (needs("held")) continue;  // a bottle pours from the hand
    // What needs no switch happens as a thing is put there, not to one that lay there from the beginning.
    if (!needs("power_on") && !needs("under_tap") && !hold(id)) continue;
    const Predicate relation = needs("on") ? Predicate::On : Predicate::Inside;
    for (const std::string& tool : nearest_of({rule}, id)) {
      const bool there = attempt_.world().linked(id, relation, tool) ||
                         put(id, needs("on") ? ActionType::PlaceOn : ActionType::PlaceIn, tool);
      const bool runs = needs("power_on") || needs("under_tap");
      if (there && !attempt_.holds(literal)) {
        if (runs && is(tool, Predicate::PowerOn)) device(ActionType::TurnOff, tool);
        if (needs("closed") && is(tool, Predicate::Open)) device(ActionType::Close, tool);
        if (runs && !attempt_.holds(literal)) device(ActionType::TurnOn, tool);
      }
      if (attempt_.holds(literal)) return true;
      if (attempt_.exhausted()) return false;
    }
  }
  return false;
}

bool Methods::place(const Literal& literal) {
  const std::string id = attempt_.id_of(literal.subject), target = attempt_.id_of(literal.object);
  if (target.empty()) return false;
  switch (literal.predicate) {
    case Predicate::On:
    case Predicate::Attached:  // what the tables say attaches does so where it is put
      return put(id, ActionType::PlaceOn, target);
    case Predicate::Inside:
      return put(id, ActionType::PlaceIn, target);
    case Predicate::OnFloor:
      return hold(id) && attempt_.act(ActionType::GoTo, target) && attempt_.act(ActionType::Drop);
    case Predicate::InRoom:
      return id == "agent" ? attempt_.act(ActionType::GoTo, target) : place_in_room(id, target);
    case Predicate::NextTo:
      if (const auto supports = attempt_.world().linked_from(target, Predicate::On); !supports.empty())
        return put(id, ActionType::PlaceOn, *std::min_element(supports.begin(), supports.end()));
      return false;
    default:
      return false;
  }
}

bool Methods::place_in_room(const std::string& id, const std::string& room) {
  if (!hold(id)) return false;
  const std::string category = find(id)->category;
  std::vector<std::string> spots;
  for (const Node& spot : attempt_.world().nodes()) {
    if (spot.movable || spots.size() == kMostSpots || attempt_.world().room_of(spot.id) != room) continue;
    if (attempt_.situation().knowledge->placement(category, "on", spot.category) != nullptr) spots.push_back(spot.id);
  }
  for (const std::string& spot : spots) {
    if (put(id, ActionType::PlaceOn, spot)) return true;
    if (attempt_.exhausted()) break;
  }
  return attempt_.act(ActionType::GoTo, room) && attempt_.act(ActionType::Drop);
}

/// In the hand a thing is on and in nothing; only a room needs it carried out.
bool Methods::take_away(const Literal& literal) {
  const std::string id = attempt_.id_of(literal.subject);
  if (literal.predicate != Predicate::InRoom) return hold(id);
  for (const Room& room : attempt_.situation().start->rooms) {
    if (room.id != attempt_.id_of(literal.object)) return place_in_room(id, room.id);
  }
  return false;
}

bool Methods::hold(const std::string& id) {
  if (attempt_.is_held(id)) return true;
  return free_hand(id) && do_at(ActionType::PickUp, id);
}

bool Methods::free_hand(const std::string& wanted) {
  const auto hands = static_cast<std::size_t>(attempt_.situation().profile.hands);
  while (attempt_.world().agent().held.size() >= hands) {
    const std::string held = attempt_.world().agent().held.front();
    if (held == wanted) return true;
    if (!put_aside(held)) return false;
  }
  return true;
}

bool Methods::put_aside(const std::string& id) {
  if (!attempt_.is_held(id)) return true;
  const auto relevant = [this](const Node& node) {
    return std::find(relevant_.begin(), relevant_.end(), node.category) != relevant_.end();
  };
  const Knowledge& knowledge = *attempt_.situation().knowledge;
  const Node* thing = find(id);
  std::vector<std::tuple<bool, bool, bool, double, std::string>> spots;
  for (const Node& node : attempt_.world().nodes()) {
    if (node.movable || node.id == id || !attempt_.world().closed_around(node.id).empty()) continue;
    const bool usual = thing != nullptr && knowledge.placement(thing->category, "on", node.category) != nullptr;
    if (!usual && !knowledge.has(node.category, "receptacle")) continue;
    const double walk = attempt_.world().walking_distance(node.id);
    if (walk >= Situation::kFar_m) continue;
    spots.emplace_back(relevant(node), !usual, !attempt_.world().in_reach(node.id), walk, node.id);
  }
  std::sort(spots.begin(), spots.end());
  if (spots.size() > kMostSpots) spots.resize(kMostSpots);
  for (const auto& spot : spots) {
    if (do_at(ActionType::PlaceOn, std::get<4>(spot))) return true;
    if (attempt_.exhausted()) return false;
  }
  return attempt_.situation().profile.offers(ActionType::Drop) && attempt_.act(ActionType::Drop);
}

bool Methods::put(const std::string& id, ActionType action, const std::string& target) {
  if (attempt_.is_held(target) && !put_aside(target)) return false;
  if (!hold(id)) return false;
  const Node* into = find(target);
  const bool shut = action == ActionType::PlaceIn && into != nullptr && into->openable && !is(target, Predicate::Open);
  if (shut && !device(ActionType::Open, target)) {
    const auto& trouble = attempt_.trouble();
    if (!trouble || trouble->failure != Failure::HandsFull || attempt_.exhausted()) return false;
    if (!put_aside(id) || !device(ActionType::Open, target) || !hold(id)) return false;
  }
  return do_at(action, target);
}

/// From a seat nothing can be done but to leave it.
bool Methods::stand_up() {
  const auto& nodes = attempt_.world().nodes();
  const bool seated = std::any_of(nodes.begin(), nodes.end(), [](const Node& node) {
    return node.states.has(Predicate::SatOn) || node.states.has(Predicate::LainOn);
  });
  return !seated || attempt_.act(ActionType::StandUp);
}

bool Methods::open_around(const std::string& id) {
  for (std::string container = attempt_.world().closed_around(id); !container.empty();
       container = attempt_.world().closed_around(id)) {
    if (!device(ActionType::Open, container)) return false;
  }
  return true;
}

bool Methods::reach(const std::string& id) {
  return attempt_.world().in_reach(id) || attempt_.act(ActionType::GoTo, id);
}

/// What is done to a thing itself, with what it needs first: no power while opening, shut and plugged in while running,
/// put down and a free hand for folding.
bool Methods::device(ActionType action, const std::string& id) {
  const Profile& profile = attempt_.situation().profile;
  const bool moves = action == ActionType::Open || action == ActionType::Close || action == ActionType::Fold ||
                     action == ActionType::Break || action == ActionType::PlugIn || action == ActionType::Unplug;
  if (moves && attempt_.is_held(id) && !put_aside(id)) return false;
  const bool power_first = action == ActionType::Open && profile.open_needs_power_off && is(id, Predicate::PowerOn);
  if (power_first && !do_at(ActionType::TurnOff, id)) return false;
  const bool shut_first = action == ActionType::TurnOn && profile.power_needs_closed && is(id, Predicate::Open);
  if (shut_first && !do_at(ActionType::Close, id)) return false;
  const bool plug_first = action == ActionType::TurnOn && profile.power_needs_plug && is(id, Predicate::Unplugged);
  if (plug_first && !do_at(ActionType::PlugIn, id)) return false;
  if (action == ActionType::Fold && !free_hand(id)) return false;
  return do_at(action, id);
}

/// The action where the object can be reached and seen; walks only when it has to.
bool Methods::do_at(ActionType action, const std::string& id) {
  if (!stand_up()) return false;
  if (!open_around(id)) return false;
  if (attempt_.world().in_reach(id)) {
    if (attempt_.act(action, id)) return true;
    const auto& trouble = attempt_.trouble();
    if (!trouble || attempt_.exhausted() || !depends_on_standing(trouble->failure)) return false;
  }
  return attempt_.act(ActionType::GoTo, id) && attempt_.act(action, id);
}

}  // namespace unietp
