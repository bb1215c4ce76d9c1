#include "pddl/direct_actions.h"

#include <algorithm>

#include "scene/action_table.h"
#include "scene/states.h"

namespace unietp::pddl {
namespace {

using Kind = ActionNeed::Kind;

std::string fact(Predicate state) { return "(" + std::string(info(state).name) + " ?t)"; }

bool has_need(const ActionInfo& action, Kind kind) {
  return std::any_of(action.needs.begin(), action.needs.end(),
                     [kind](const ActionNeed& need) { return need.kind == kind; });
}

}  // namespace

std::vector<std::string> own_needs(const ActionInfo& action) {
  // What is in one of the states of a group is in another one of them: no negation for planners.
  const bool in_group = has_need(action, Kind::Varies) || action.starts_tool;
  std::vector<std::string> needs;
  for (const ActionNeed& need : action.needs) {
    if (need.rule != ActionRule::Always) continue;
    if (need.kind == Kind::Affordance) needs.push_back("(" + std::string(need.affordance) + " ?t)");
    if (need.kind == Kind::Is) needs.push_back(fact(need.state));
    if (need.kind == Kind::IsNot && !in_group) needs.push_back("(not " + fact(need.state) + ")");
    if (need.kind == Kind::IsNot && in_group) needs.push_back(fact(*opposite_of(need.state)));
    if (need.kind == Kind::HandFree) needs.emplace_back("(hand-empty)");
    if (need.kind == Kind::Standing) needs.emplace_back("(not (seated))");
    if (need.kind == Kind::Unloaded) needs.emplace_back("(forall (?w - movable) (or (= ?w ?t) (not (rests ?w ?t))))");
  }
  return needs;
}

std::vector<std::string> needs_by_rule(const ActionInfo& action, ActionRule rule) {
  std::vector<std::string> needs;
  for (const ActionNeed& need : action.needs) {
    if (need.rule == rule) needs.push_back("(not " + fact(need.state) + ")");
  }
  return needs;
}

std::vector<std::string> own_effects(const ActionInfo& action) {
  std::vector<std::string> effects;
  for (const ActionChange& change : action.changes) {
    const auto text = becomes(change.state, "?t");
    effects.push_back(change.only_if ? "(when " + fact(*change.only_if) + " (and " + text + "))" : text);
    if (change.state == Predicate::Empty) effects.emplace_back("(forall (?s - substance) (not (filled-with ?t ?s)))");
    if (change.state == Predicate::SatOn || change.state == Predicate::LainOn) effects.emplace_back("(seated)");
  }
  return effects;
}

std::vector<ActionText> direct_actions(const ActionSet& offered) {
  std::vector<ActionText> actions;
  for (const ActionInfo& action : action_table()) {
    if (!offered[static_cast<std::size_t>(action.type)]) continue;
    const std::string name(action.name);
    if (action.type == ActionType::StandUp) {
      actions.push_back({name,
                         "",
                         {"(seated)"},
                         {"(not (seated))", "(forall (?t - thing) (and (not (sat_on ?t)) (not (lain_on ?t))))"}});
    }
    if (action.changes.empty() || action.starts_tool) continue;
    const auto add = [&](const std::string& suffix, const char* type, const std::vector<std::string>& where) {
      auto needs = own_needs(action);
      needs.insert(needs.end(), where.begin(), where.end());
      actions.push_back({name + suffix, std::string("?t - ") + type, std::move(needs), own_effects(action)});
    };
    if (!has_need(action, Kind::InHand)) add("", "thing", {"(near ?t)", "(free ?t)"});
    if (has_need(action, Kind::InHand) || has_need(action, Kind::ReachOrInHand)) add("-held", "movable", {"(held ?t)"});
  }
  return actions;
}

}  // namespace unietp::pddl
