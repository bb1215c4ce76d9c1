#include "expert/methods.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "expert/achievers.h"
#include "scene/states.h"

namespace unietp {
namespace {

constexpr std::size_t kMostTools = 4;  // tools tried for one change

/// Failures that may not happen from another place to stand.
bool depends_on_standing(Failure failure) {
  switch (failure) {
    case Failure::TooFar:
    case Failure::NotVisible:
    case Failure::Blocked:
    case Failure::NoFreePlace:
    case Failure::DidNotRest:
    case Failure::NoStandingPlace:
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
  return literal.predicate == Predicate::Covered && with_held_tool(whatever, ActionType::Wipe, Treatment::Wipes);
}

bool Methods::change_state(const Literal& literal) {
  const std::string id = attempt_.id_of(literal.subject);
  for (const Achiever& achiever : achievers_of(literal.predicate, attempt_.situation().profile)) {
    bool done = false;
    switch (achiever.kind) {
      case AchieverKind::Direct:
        done = directly(achiever.action, id);
        break;
      case AchieverKind::ToolOnHeld:
        done = with_tool_on_held(literal, achiever.action, *achiever.treatment);
        break;
      case AchieverKind::HeldToolOn:
        done = with_held_tool(literal, achiever.action, *achiever.treatment);
        break;
      case AchieverKind::Appliance:
        done = in_appliance(literal, *achiever.treatment);
        break;
      case AchieverKind::FromVessel:
        done = pour_from_vessel(literal);
        break;
    }
    if (done && attempt_.holds(literal)) return true;
  }
  return false;
}

/// Those in hand first, then the nearest; by where they and the agent are now, whenever the next one is asked for. What
/// there is a way to only once a door is shut is as far as it is then.
Methods::Tools Methods::nearest_of(const std::vector<const Effect*>& rules, const std::string& except) const {
  const World here = attempt_.world();
  const auto rank = [this, here](const std::string& id, double away, std::string name) {
    const bool avoided = std::find(shunned_.begin(), shunned_.end(), id) != shunned_.end();
    const auto& held = here.agent().held;
    return ToolRank(avoided, std::find(held.begin(), held.end(), id) == held.end(), away, std::move(name));
  };
  const auto away = [this, here](const std::string& id) {
    const double way = here.walking_distance(id);
    if (std::isfinite(way)) return way;
    for (const auto& shut : ways_to_shut_a_door(id)) {
      World later = here;
      const bool works =
          std::all_of(shut.begin(), shut.end(), [&](const Action& step) { return later.step(step).success; });
      if (works && std::isfinite(later.walking_distance(id))) return later.walking_distance(id);
    }
    return way;
  };
  Tools tools(kMostTools, [away, rank](const std::string& id) { return rank(id, away(id), id); });
  std::set<std::string_view> categories;
  for (const Effect* rule : rules) categories.insert(rule->tool);
  for (const std::string_view category : categories) {
    for (const std::size_t place : here.places().of(category)) {
      const Node& tool = here.nodes()[place];
      if (tool.id != except) tools.add(tool.id, rank(tool.id, here.straight_distance(tool), ""));
    }
  }
  return tools;
}

bool Methods::with_held_tool(const Literal& literal, ActionType action, Treatment treatment) {
  const std::string id = attempt_.id_of(literal.subject);
  const Achiever achiever{literal.predicate, AchieverKind::HeldToolOn, action, "", treatment};
  const Node* node = find(id);
  const auto rules = node == nullptr ? std::vector<const Effect*>()
                                     : rules_for(achiever, node->category, literal.symbol, attempt_.world().places(),
                                                 *attempt_.situation().knowledge);
  if (rules.empty()) return false;
  if (attempt_.is_held(id) && !put_aside(id)) return false;
  // Slices may lie where they cannot be got at: out with it before it is cut.
  const bool shut_in = action == ActionType::Slice && !attempt_.world().linked_from(id, Predicate::Inside).empty();
  if (clears_ && shut_in && !(hold(id) && put_aside(id))) return false;
  Tools tools = nearest_of(rules, id);
  while (const auto next = tools.next()) {
    const std::string& tool = *next;
    if (action == ActionType::PourTo && !is(tool, Predicate::Filled)) continue;
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

/// From what is filled so already, else from what can be, the nearest first.
bool Methods::pour_from_vessel(const Literal& literal) {
  const std::string id = attempt_.id_of(literal.subject);
  const Situation& situation = attempt_.situation();
  if (pours_ || !situation.knowledge->has(situation.entity(literal.subject).category, "fillable")) return false;
  std::vector<std::tuple<bool, double, Literal>> vessels;
  for (EntityIndex entity; entity < situation.first_imagined; ++entity) {
    const Node* node = attempt_.node(entity);
    if (node == nullptr || !node->movable || node->id == id) continue;
    if (!situation.knowledge->has(node->category, "fillable")) continue;
    Literal filled = literal;
    filled.subject = entity;
    if (!achievable(filled, situation) && !attempt_.holds(filled)) continue;
    vessels.emplace_back(!attempt_.holds(filled), attempt_.world().walking_distance(node->id), filled);
  }
  std::stable_sort(vessels.begin(), vessels.end(), [](const auto& a, const auto& b) {
    return std::tie(std::get<0>(a), std::get<1>(a)) < std::tie(std::get<0>(b), std::get<1>(b));
  });
  if (vessels.size() > kMostTools) vessels.resize(kMostTools);
  for (const auto& [empty, away, filled] : vessels) {
    pours_ = true;  // a vessel is not filled from another in its turn
    const bool ready = attempt_.holds(filled) || change_state(filled);
    pours_ = false;
    if (ready && hold(attempt_.id_of(filled.subject)) && do_at(ActionType::PourTo, id)) return true;
    if (attempt_.exhausted()) return false;
  }
  return false;
}

bool Methods::with_tool_on_held(const Literal& literal, ActionType action, Treatment treatment) {
  const std::string id = attempt_.id_of(literal.subject);
  const Achiever achiever{literal.predicate, AchieverKind::ToolOnHeld, action, "", treatment};
  const Node* node = find(id);
  if (node == nullptr) return false;
  const auto rules =
      rules_for(achiever, node->category, literal.symbol, attempt_.world().places(), *attempt_.situation().knowledge);
  if (rules.empty() || !hold(id)) return false;
  Tools tools = nearest_of(rules, id);
  while (const auto next = tools.next()) {
    const std::string& tool = *next;
    if (do_at(action, tool)) return true;
    const auto& trouble = attempt_.trouble();
    if (attempt_.exhausted() || not_run_here(trouble)) return false;
    if (trouble->failure == Failure::MustBeClosed && is(tool, Predicate::Open)) {
      if (directly(ActionType::Close, tool) && do_at(action, tool)) return true;
    } else if (is(tool, Predicate::Closed)) {
      // With the door open, one stands elsewhere and sees what one lets go of.
      if (directly(ActionType::Open, tool) && hold(id) && attempt_.act(ActionType::GoTo, tool) &&
          attempt_.act(action, tool))
        return true;
    }
    if (make_room(id, action, tool)) return true;
  }
  return false;
}

/// What the tool does by itself: into it (or on it), door shut, power or water on. The object stays there.
bool Methods::in_appliance(const Literal& literal, Treatment treatment) {
  const std::string id = attempt_.id_of(literal.subject);
  const Node* node = find(id);
  if (node == nullptr || !node->movable) return false;
  const Achiever achiever{literal.predicate, AchieverKind::Appliance, ActionType::PlaceIn, "", treatment};
  for (const Effect* rule : rules_for(achiever, node->category, literal.symbol, attempt_.world().places(),
                                      *attempt_.situation().knowledge)) {
    const auto needs = [rule](EffectNeed need) { return has_need(*rule, need); };
    if (needs(EffectNeed::Held)) continue;  // a bottle pours from the hand
    // What needs no switch happens as a thing is put there, not to one that lay there from the beginning.
    if (!needs(EffectNeed::PowerOn) && !needs(EffectNeed::UnderTap) && !hold(id)) continue;
    const Predicate relation = needs(EffectNeed::On) ? Predicate::On : Predicate::Inside;
    Tools tools = nearest_of({rule}, id);
    while (const auto next = tools.next()) {
      const std::string& tool = *next;
      const bool there = attempt_.world().linked(id, relation, tool) ||
                         put_in_grasp(id, needs(EffectNeed::On) ? ActionType::PlaceOn : ActionType::PlaceIn, tool);
      const bool runs = needs(EffectNeed::PowerOn) || needs(EffectNeed::UnderTap);
      if (there && !attempt_.holds(literal)) {
        if (runs && is(tool, Predicate::PowerOn)) directly(ActionType::TurnOff, tool);
        if (needs(EffectNeed::Closed) && is(tool, Predicate::Open)) directly(ActionType::Close, tool);
        if (runs && !attempt_.holds(literal)) directly(ActionType::TurnOn, tool);
      }
      if (attempt_.holds(literal)) return true;
      if (attempt_.exhausted()) return false;
    }
  }
  return false;
}

/// From a seat nothing can be done but to leave it.
bool Methods::stand_up() {
  const Profile& profile = attempt_.situation().profile;
  if (!profile.offers(ActionType::SitOn) && !profile.offers(ActionType::LieOn)) return true;
  const auto& nodes = attempt_.world().nodes();
  const bool seated = std::any_of(nodes.begin(), nodes.end(), [](const Node& node) {
    return node.states.has(Predicate::SatOn) || node.states.has(Predicate::LainOn);
  });
  return !seated || attempt_.act(ActionType::StandUp);
}

bool Methods::open_around(const std::string& id) {
  for (std::string container = attempt_.world().closed_around(id); !container.empty();
       container = attempt_.world().closed_around(id)) {
    if (!directly(ActionType::Open, container)) return false;
  }
  return true;
}

/// Whether the simulator has the rule.
bool Methods::applies(ActionRule rule) const {
  const Profile& profile = attempt_.situation().profile;
  switch (rule) {
    case ActionRule::Always:
      return true;
    case ActionRule::OpenNeedsPowerOff:
      return profile.open_needs_power_off;
    case ActionRule::PowerNeedsClosed:
      return profile.power_needs_closed;
    case ActionRule::PowerNeedsPlug:
      return profile.power_needs_plug;
    case ActionRule::TargetFills:
    case ActionRule::TargetStained:
      break;  // of no direct action
  }
  return true;
}

/// Brings about what a direct action needs of the object's states: no power while opening, shut while running.
bool Methods::bring_about(const ActionNeed& need, const std::string& id, Predicate aim) {
  using Kind = ActionNeed::Kind;
  const auto other = opposite_of(need.state);
  const bool state = need.kind == Kind::Is || need.kind == Kind::IsNot;
  if (!state || !applies(need.rule) || need.state == aim || other == aim) return true;
  if (is(id, need.state) == (need.kind == Kind::Is)) return true;
  const auto wanted = need.kind == Kind::Is ? std::optional(need.state) : other;
  const auto first = wanted ? direct_action(*wanted) : std::nullopt;
  return first && do_at(*first, id);
}

/// An action on an object itself, with what it needs first.
bool Methods::directly(ActionType action, const std::string& id) {
  using Kind = ActionNeed::Kind;
  const ActionInfo& about = info(action);
  const auto needs = [&about](Kind kind) {
    return std::any_of(about.needs.begin(), about.needs.end(), [kind](const auto& need) { return need.kind == kind; });
  };
  if (needs(Kind::NotInHand) && attempt_.is_held(id) && !put_aside(id)) return false;
  for (const ActionNeed& need : about.needs) {
    if (!bring_about(need, id, about.changes.front().state)) return false;
  }
  if (needs(Kind::HandFree) && !free_hand(id)) return false;
  if (needs(Kind::InHand)) return hold(id) && attempt_.act(action, id);
  const bool swings = action == ActionType::Open || action == ActionType::Close;
  return do_at(action, id) || (swings && unblock(action, id));
}

/// The action where the object can be reached and seen; walks only when it has to, first to where one is led, then to
/// wherever it works.
bool Methods::do_at(ActionType action, const std::string& id) {
  if (!stand_up()) return false;
  if (!open_around(id)) return false;
  if (attempt_.world().in_reach(id)) {
    if (attempt_.act(action, id)) return true;
    const auto& trouble = attempt_.trouble();
    if (!trouble || attempt_.exhausted() || !depends_on_standing(trouble->failure)) return false;
  }
  if ((attempt_.act(ActionType::GoTo, id) || shut_out_of_the_way(id)) && attempt_.act(action, id)) return true;
  const auto& trouble = attempt_.trouble();
  return trouble && depends_on_standing(trouble->failure) && from_elsewhere({action, {id}}, id, {});
}

/// Ways to shut one of the doors that stand open, but not one of what the object is in.
std::vector<std::vector<Action>> Methods::ways_to_shut_a_door(const std::string& id) const {
  const World& world = attempt_.world();
  std::vector<std::vector<Action>> ways;
  for (const Node& node : world.nodes()) {
    const bool open = !node.movable && node.openable && node.states.has(Predicate::Open);
    if (!open || world.linked(id, Predicate::Inside, node.id)) continue;
    const Action back{ActionType::GoTo, {node.id}}, shut{ActionType::Close, {node.id}};
    if (world.in_reach(node.id)) ways.push_back({shut});
    ways.push_back({back, shut});
  }
  return ways;
}

/// Who opened a door may stand behind it, in a corner that leads nowhere. Shuts one after which there is a way, and
/// goes.
bool Methods::shut_out_of_the_way(const std::string& id) {
  for (auto& way : ways_to_shut_a_door(id)) {
    way.push_back({ActionType::GoTo, {id}});
    if (works(way))
      return std::all_of(way.begin(), way.end(), [this](const Action& step) { return attempt_.act(step); });
  }
  return false;
}

bool Methods::from_elsewhere(const Action& action, const std::string& about, const Postcondition& aim) {
  if (attempt_.exhausted()) return false;
  const auto way = steps_to_act(attempt_.world(), action, about, aim);
  return way && std::all_of(way->begin(), way->end(), [this](const Action& step) { return attempt_.act(step); }) &&
         attempt_.act(action);
}

}  // namespace unietp
