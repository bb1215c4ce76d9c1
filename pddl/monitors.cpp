#include "pddl/monitors.h"

#include "scene/states.h"

namespace unietp::pddl {
namespace {

std::string sees(const MonitoredPredicate& watched, bool negative) {
  return "(watches-" + std::string(negative ? "not-" : "") + watched.name + " ?m " + watched.variables + ")";
}

}  // namespace

const std::vector<MonitoredPredicate>& all_watched() {
  static const auto kAll = [] {
    std::vector<MonitoredPredicate> all;
    for (const auto& group : state_groups()) {
      for (const auto state : group.predicates)
        all.push_back({state, std::string(info(state).name), "?x - thing", "?x"});
    }
    all.push_back({Predicate::Held, "held", "?x - thing", "?x"});
    all.push_back({Predicate::On, "on", "?x ?y - thing", "?x ?y"});
    all.push_back({Predicate::Inside, "inside", "?x ?y - thing", "?x ?y"});
    all.push_back({Predicate::OnFloor, "on_floor", "?x - thing ?y - room", "?x ?y"});
    all.push_back({Predicate::InRoom, "in_room", "?x - thing ?y - room", "?x ?y"});
    all.push_back({Predicate::InRoom, "agent-in", "?x - room", "?x"});
    all.push_back({Predicate::Filled, "filled-with", "?x - thing ?y - substance", "?x ?y"});
    all.push_back({Predicate::Covered, "covered-with", "?x - thing ?y - substance", "?x ?y"});
    for (const auto& action : extension_actions()) {
      const bool alone = !action.changes.empty() && info(action.changes.front().state).group.empty();
      if (!alone) continue;
      const auto state = action.changes.front().state;
      all.push_back({state, std::string(info(state).name), "?x - thing", "?x"});
    }
    return all;
  }();
  return kAll;
}

std::vector<MonitoredPredicate> watched_with(const ActionSet& offered) {
  std::vector<MonitoredPredicate> found;
  for (const auto& watched : all_watched()) {
    const auto action = direct_action(watched.predicate);
    const bool extension = info(watched.predicate).group.empty() && action && is_extension(*action);
    if (!extension || offered[static_cast<std::size_t>(*action)]) found.push_back(watched);
  }
  return found;
}

std::vector<PredicateText> monitor_predicates(const ActionSet& offered) {
  std::vector<PredicateText> all = {{"watching", ""},
                                    {"ready", ""},
                                    {"to-note", ""},
                                    {"to-judge", ""},
                                    {"now", "?m - monitor"},
                                    {"seen", "?m - monitor"},
                                    {"missed", "?m - monitor"},
                                    {"ordered", "?m ?n - monitor"},
                                    {"in-order", "?m ?n - monitor"},
                                    {"kept-until", "?m ?n - monitor"},
                                    {"not-kept", "?m ?n - monitor"}};
  for (const auto& watched : watched_with(offered)) {
    all.push_back({"watches-" + watched.name, "?m - monitor " + watched.arguments});
    all.push_back({"watches-not-" + watched.name, "?m - monitor " + watched.arguments});
  }
  return all;
}

std::vector<ActionText> monitor_actions(const ActionSet& offered) {
  ActionText note{"note", "", {"(to-note)"}, {"(not (to-note))", "(to-judge)"}};
  for (const auto& watched : watched_with(offered)) {
    const auto fact = "(" + watched.name + " " + watched.variables + ")";
    const auto variables = "(?m - monitor " + watched.arguments + ") ";
    for (const bool negative : {false, true}) {
      const auto so = negative ? "(not " + fact + ")" : fact;
      const auto not_so = negative ? fact : "(not " + fact + ")";
      note.effects.push_back("(forall " + variables + "(when (and " + sees(watched, negative) + " " + so +
                             ") (now ?m)))");
      note.effects.push_back("(forall " + variables + "(when (and " + sees(watched, negative) + " " + not_so +
                             ") (not (now ?m))))");
    }
  }
  const std::string not_kept =
      "(forall (?m ?n - monitor) (when (and (kept-until ?m ?n) (not (seen ?n)) (not (now ?n)) (not (now ?m))) "
      "(not-kept ?m ?n)))";
  const ActionText judge{
      "judge",
      "",
      {"(to-judge)"},
      {"(not (to-judge))", "(ready)", "(forall (?m - monitor) (when (now ?m) (seen ?m)))",
       "(forall (?m - monitor) (when (not (now ?m)) (missed ?m)))",
       "(forall (?m ?n - monitor) (when (and (ordered ?m ?n) (now ?n) (seen ?m) (not (seen ?n))) (in-order ?m ?n)))",
       not_kept}};
  return {note, judge};
}

}  // namespace unietp::pddl
