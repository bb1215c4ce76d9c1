#include "pddl/domain.h"

#include <algorithm>

#include "pddl/monitors.h"
#include "scene/states.h"

namespace unietp::pddl {
namespace {

std::string bracketed(const std::string& name, const std::string& arguments) {
  return "(" + name + (arguments.empty() ? "" : " ") + arguments + ")";
}

std::string text_of(const ActionText& action, bool watched) {
  auto text = "  (:action " + action.name + "\n    :parameters (" + action.parameters + ")\n    :precondition (and";
  if (watched) text += " (ready)";
  for (const auto& need : action.needs) text += " " + need;
  text += ")\n    :effect (and\n";
  for (const auto& effect : action.effects) text += "      " + effect + "\n";
  if (watched) text += "      (when (watching) (and (not (ready)) (to-note)))\n";
  return text + "    ))\n";
}

}  // namespace

std::string domain_name(Simulator simulator) { return "unietp-" + std::string(name_of(simulator)); }

std::string becomes(Predicate state, const std::string& thing) {
  std::string text = "(" + std::string(info(state).name) + " " + thing + ")";
  for (const auto& group : state_groups()) {
    bool own = false;
    for (const auto other : group.predicates) own = own || other == state;
    if (!own) continue;
    for (const auto other : group.predicates) {
      if (other != state) text += " (not (" + std::string(info(other).name) + " " + thing + "))";
    }
  }
  return text;
}

std::vector<std::string_view> affordances_for(const ActionSet& offered) {
  std::vector<std::string_view> affordances;
  for (const ActionInfo& action : extension_actions()) {
    const bool asks = std::any_of(action.needs.begin(), action.needs.end(),
                                  [](const ActionNeed& need) { return need.kind == ActionNeed::Kind::Affordance; });
    const auto name = affordance_for(action);  // actions may share one: fold and unfold
    const bool listed = std::find(affordances.begin(), affordances.end(), name) != affordances.end();
    if (asks && !listed && offered[static_cast<std::size_t>(action.type)]) affordances.push_back(name);
  }
  return affordances;
}

std::vector<PredicateText> predicates_of(const ActionSet& offered, const std::vector<ProcessClass>& processes) {
  std::vector<PredicateText> all;
  for (const char* name : {"pickupable", "openable", "fillable", "consumable", "shuts-to-run"})
    all.push_back({name, "?x - thing"});
  for (const auto name : affordances_for(offered)) all.push_back({std::string(name), "?x - thing"});
  for (const char* name : {"fits-on", "fits-in", "cuts", "wipes", "drains", "can-cool"})
    all.push_back(
        {name, name == std::string("drains") || name == std::string("can-cool") ? "?t ?x - thing" : "?x ?t - thing"});
  all.push_back({"dispenses", "?x ?t - thing ?s - substance"});
  all.push_back({"staining", "?s - substance"});
  all.push_back({"piece-of", "?p ?t - thing"});
  all.push_back({"piece-by", "?p ?x - thing"});
  for (const auto& process : processes) {
    const bool fills = process.treatment == Treatment::Fills;
    all.push_back({name_of(process), std::string("?t ?x - thing") + (fills ? " ?s - substance" : "")});
  }
  for (const char* name : {"present", "near", "free", "standing", "stained"}) all.push_back({name, "?x - thing"});
  for (const char* name : {"rests", "shut"}) all.push_back({name, "?x ?y - thing"});
  all.push_back({"hand-empty", ""});
  if (offered[static_cast<std::size_t>(ActionType::StandUp)]) all.push_back({"seated", ""});
  for (const auto& watched : watched_with(offered)) all.push_back({watched.name, watched.arguments});
  return all;
}

std::string domain_text(const Knowledge& knowledge, ActionProfile profile) {
  const auto offered = unietp::actions_of(knowledge.simulator(), profile);
  const auto processes = classes_of(knowledge);
  std::string text = "(define (domain " + domain_name(knowledge.simulator()) +
                     ")\n"
                     "  (:requirements :strips :typing :equality :negative-preconditions :disjunctive-preconditions\n"
                     "    :conditional-effects" +
                     (profile == ActionProfile::Wide ? " :universal-preconditions" : "") +
                     ")\n"
                     "  (:types thing room substance monitor - object movable - thing)\n"
                     "  (:predicates\n";
  for (const auto& predicate : predicates_of(offered, processes))
    text += "    " + bracketed(predicate.name, predicate.arguments) + "\n";
  for (const auto& predicate : monitor_predicates(offered))
    text += "    " + bracketed(predicate.name, predicate.arguments) + "\n";
  text += "  )\n";
  for (const auto& action : actions_of(offered, processes)) text += text_of(action, true);
  for (const auto& action : monitor_actions(offered)) text += text_of(action, false);
  return text + ")\n";
}

}  // namespace unietp::pddl
