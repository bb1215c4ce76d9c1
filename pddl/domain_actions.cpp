#include <algorithm>

#include "pddl/direct_actions.h"
#include "scene/states.h"
#include "symbolic/perform.h"

namespace unietp::pddl {
namespace {

using Place = ProcessClass::Place;
using Lines = std::vector<std::string>;

std::string when(const std::string& condition, const std::string& effects) {
  return "(when (and " + condition + ") (and " + effects + "))";
}
std::string for_all(const std::string& variables, const std::string& effect) {
  return "(forall (" + variables + ") " + effect + ")";
}

/// The states that a process sets.
std::string made_of(const ProcessClass& process, const std::string& thing) {
  std::string text;
  for (const auto state : sets(process.treatment)) text += (text.empty() ? "" : " ") + becomes(state, thing);
  if (process.treatment == Treatment::Washes) text += " (not (stained " + thing + "))";
  if (process.treatment == Treatment::Fills) text += " (filled-with " + thing + " ?s)";
  return text;
}

/// How the tool ?t is when its processes run: nullopt where that depends on the moment.
struct Moment {
  std::optional<bool> closed, power;
  bool tap = false;
};

/// What a process does to things of which `condition` holds, if the moment lets it.
void add_process(const ProcessClass& process, const Moment& moment, const std::string& condition,
                 const std::string& thing, bool quantified, Lines& effects) {
  const bool power = process.power || (process.tap && !moment.tap);  // a tap runs while it is on, too
  if ((process.closed && moment.closed == false) || (power && moment.power == false)) return;
  const bool fills = process.treatment == Treatment::Fills;
  std::string when_all = "(" + name_of(process) + " ?t " + thing + (fills ? " ?s)" : ")");
  if (!condition.empty()) when_all = condition + " " + when_all;
  if (process.closed && !moment.closed) when_all += " (closed ?t)";
  if (power && !moment.power) when_all += " (power_on ?t)";
  const auto add = [&](const std::string& more, const std::string& condition_too, const std::string& effect) {
    auto variables = std::string(quantified ? "?w - movable" : "");
    if (fills) variables += std::string(variables.empty() ? "" : " ") + "?s - substance";
    variables += more.empty() ? "" : (variables.empty() ? "" : " ") + more;
    const auto conditional = when(when_all + condition_too, effect);
    effects.push_back(variables.empty() ? conditional : for_all(variables, conditional));
  };
  add("", "", made_of(process, thing));
  if (process.treatment == Treatment::Washes) add("?q - substance", "", "(not (covered-with " + thing + " ?q))");
  if (fills) add("?q - substance", " (not (= ?q ?s))", "(not (filled-with " + thing + " ?q))");
}

/// To what is on or in the tool already.
void run_on_content(const std::vector<ProcessClass>& processes, const Moment& moment, Lines& effects) {
  for (const auto& process : processes) {
    const std::string there = process.place == Place::On       ? "(on ?w ?t)"
                              : process.place == Place::Inside ? "(inside ?w ?t)"
                                                               : "(rests ?w ?t) (not (= ?w ?t))";
    add_process(process, moment, there, "?w", true, effects);
  }
}

/// To ?x, which is put there with all that it carries.
void run_on_new(const std::vector<ProcessClass>& processes, const Moment& moment, Place place, Lines& effects) {
  for (const auto& process : processes) {
    if (process.place == Place::Inside && place != Place::Inside) continue;
    if (process.place == Place::On) {
      if (place == Place::On) add_process(process, moment, "", "?x", false, effects);
    } else {
      add_process(process, moment, "(rests ?w ?x)", "?w", true, effects);
    }
  }
}

const Lines kLeavesPlace = {
    "(not (standing ?x))",
    for_all("?w - movable", when("(rests ?w ?x)", "(not (near ?w))")),
    for_all("?w - movable ?z - thing", when("(rests ?w ?x) (rests ?x ?z) (not (= ?x ?z))", "(not (rests ?w ?z))")),
    for_all("?w - movable ?z - thing", when("(rests ?w ?x) (inside ?x ?z)", "(not (inside ?w ?z))")),
    for_all("?z - thing", "(not (on ?x ?z))"),
    for_all("?r - room", "(not (on_floor ?x ?r))"),
    for_all("?w - movable ?r - room", when("(rests ?w ?x)", "(not (in_room ?w ?r))")),
};
/// ?x comes to ?t.
const Lines kComesToPlace = {
    "(not (held ?x))",
    "(hand-empty)",
    for_all("?w - movable", when("(rests ?w ?x)", "(near ?w)")),
    for_all("?w - movable ?z - thing", when("(rests ?w ?x) (rests ?t ?z)", "(rests ?w ?z)")),
    for_all("?w - movable ?z - thing", when("(rests ?w ?x) (inside ?t ?z)", "(inside ?w ?z)")),
    for_all("?w - movable ?r - room", when("(rests ?w ?x) (in_room ?t ?r)", "(in_room ?w ?r)")),
};

const Lines kInReach = {"(near ?t)", "(free ?t)"};

Lines joined(Lines first, const Lines& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// The needs with one more if it is asked for.
Lines with(bool asked, Lines needs, const char* more) {
  if (asked) needs.emplace_back(more);
  return needs;
}

class ActionWriter {
 public:
  ActionWriter(const ActionSet& offered, const std::vector<ProcessClass>& processes)
      : offered_(offered), processes_(processes) {}

  std::vector<ActionText> write() {
    add_going();
    add_moving();
    add_doors();
    add_power();
    add_contents();
    for (const auto& process : processes_) add_composite(process);
    return std::move(actions_);
  }

 private:
  bool has(ActionType type) const { return offered_[static_cast<std::size_t>(type)]; }
  void add(ActionType type, const std::string& suffix, const std::string& parameters, Lines needs, Lines effects) {
    if (has(type))
      actions_.push_back({std::string(info(type).name) + suffix, parameters, std::move(needs), std::move(effects)});
  }

  void add_going() {
    // To what stands on the floor; with it to all that rests on it.
    const bool sits = has(ActionType::StandUp);
    add(ActionType::GoTo, "", "?f - thing ?r - room",
        with(sits, {"(standing ?f)", "(in_room ?f ?r)"}, "(not (seated))"),
        {"(agent-in ?r)", for_all("?q - room", when("(not (= ?q ?r))", "(not (agent-in ?q))")),
         for_all("?w - thing", when("(rests ?w ?f)", "(near ?w)")),
         for_all("?w - thing", when("(not (rests ?w ?f))", "(not (near ?w))"))});
    add(ActionType::GoTo, "-room", "?r - room", with(sits, {}, "(not (seated))"),
        {"(agent-in ?r)", for_all("?q - room", when("(not (= ?q ?r))", "(not (agent-in ?q))")),
         for_all("?w - thing", "(not (near ?w))")});
  }

  void add_moving() {
    add(ActionType::PickUp, "", "?x - movable",
        with(has(ActionType::StandUp), {"(pickupable ?x)", "(hand-empty)", "(near ?x)", "(free ?x)"},
             "(not (sat_on ?x)) (not (lain_on ?x))"),
        joined({"(held ?x)", "(not (hand-empty))"}, kLeavesPlace));
    auto on = joined({"(on ?x ?t)"}, kComesToPlace);
    run_on_content(processes_, {}, on);
    run_on_new(processes_, {}, Place::On, on);
    add(ActionType::PlaceOn, "", "?x - movable ?t - thing", {"(held ?x)", "(near ?t)", "(free ?t)", "(fits-on ?x ?t)"},
        std::move(on));
    auto in = joined({for_all("?w - movable", when("(rests ?w ?x)", "(inside ?w ?t)"))}, kComesToPlace);
    run_on_content(processes_, {false, {}, false}, in);
    run_on_new(processes_, {false, {}, false}, Place::Inside, in);
    add(ActionType::PlaceIn, "", "?x - movable ?t - thing",
        {"(held ?x)", "(near ?t)", "(free ?t)", "(fits-in ?x ?t)", "(not (closed ?t))"}, std::move(in));
    add(ActionType::Drop, "", "?x - movable ?r - room", {"(held ?x)", "(agent-in ?r)"},
        {"(not (held ?x))", "(hand-empty)", "(standing ?x)", "(on_floor ?x ?r)",
         for_all("?w - movable", when("(rests ?w ?x)", "(in_room ?w ?r)"))});
  }

  /// Opening, closing and switching: the needs and changes of their rows, and what the tool then does.
  void add_doors() {
    const ActionInfo& opening = info(ActionType::Open);
    auto opens = own_effects(opening);
    opens.push_back(for_all("?w - thing", when("(shut ?w ?t)", "(not (shut ?w ?t)) (free ?w)")));
    run_on_content(processes_, {false, {}, false}, opens);
    // No action bears the name of a predicate: some tools keep one list of names.
    add(ActionType::Open, "-shut", "?t - thing",
        joined(joined(own_needs(opening), kInReach), needs_by_rule(opening, ActionRule::OpenNeedsPowerOff)),
        std::move(opens));
    const ActionInfo& closing = info(ActionType::Close);
    auto closes = own_effects(closing);
    closes.push_back(for_all("?w - thing", when("(inside ?w ?t) (free ?w)", "(shut ?w ?t) (not (free ?w))")));
    run_on_content(processes_, {true, {}, false}, closes);
    add(ActionType::Close, "", "?t - thing", joined(own_needs(closing), kInReach), std::move(closes));
  }

  void add_power() {
    const ActionInfo &turning_on = info(ActionType::TurnOn), &turning_off = info(ActionType::TurnOff);
    auto on = own_effects(turning_on), off = own_effects(turning_off);
    run_on_content(processes_, {{}, true, false}, on);
    run_on_content(processes_, {{}, false, false}, off);
    const auto turns_on = [&](const char* suffix, const char* parameters, const Lines& needs) {
      auto all = joined(own_needs(turning_on), needs);
      if (has(ActionType::PlugIn)) all = joined(std::move(all), needs_by_rule(turning_on, ActionRule::PowerNeedsPlug));
      add(ActionType::TurnOn, suffix, parameters, std::move(all), on);
    };
    turns_on("", "?t - thing", joined(kInReach, {"(not (shuts-to-run ?t))"}));
    turns_on("-shut", "?t - thing",
             joined(joined(kInReach, {"(shuts-to-run ?t)"}), needs_by_rule(turning_on, ActionRule::PowerNeedsClosed)));
    turns_on("-held", "?t - movable", {"(held ?t)", "(not (shuts-to-run ?t))"});
    add(ActionType::TurnOff, "", "?t - thing", joined(own_needs(turning_off), kInReach), off);
    add(ActionType::TurnOff, "-held", "?t - movable", joined(own_needs(turning_off), {"(held ?t)"}), off);
  }

  void add_contents() {
    Lines cuts = {becomes(Predicate::Sliced, "?t")};
    for (const auto* relation : {"(rests ?t ?z) (not (= ?t ?z))", "(inside ?t ?z)", "(on ?t ?z)", "(shut ?t ?z)"}) {
      const std::string fact(relation);
      const auto name = fact.substr(1, fact.find(' ') - 1);
      cuts.push_back(for_all("?p - movable ?z - thing",
                             when("(piece-of ?p ?t) (piece-by ?p ?x) " + fact, "(" + name + " ?p ?z)")));
    }
    for (const auto* fact : {"in_room", "on_floor"}) {
      const std::string name(fact);
      cuts.push_back(for_all("?p - movable ?r - room",
                             when("(piece-of ?p ?t) (piece-by ?p ?x) (" + name + " ?t ?r)", "(" + name + " ?p ?r)")));
    }
    for (const std::string name : {"covered-with", "filled-with"})
      cuts.push_back(for_all("?p - movable ?q - substance",
                             when("(piece-of ?p ?t) (piece-by ?p ?x) (" + name + " ?t ?q)", "(" + name + " ?p ?q)")));
    std::vector<std::string> copied{"standing", "stained"};
    for (const auto& group : state_groups()) {
      for (const auto state : group.predicates) {
        if (state != Predicate::Whole && state != Predicate::Sliced) copied.emplace_back(info(state).name);
      }
    }
    cuts.push_back(for_all("?p - movable", when("(piece-of ?p ?t) (piece-by ?p ?x)", "(present ?p) (free ?p)")));
    cuts.push_back(for_all("?p - movable", when("(piece-of ?p ?t) (piece-by ?p ?x) (not (standing ?t))", "(near ?p)")));
    for (const auto& name : copied)
      cuts.push_back(
          for_all("?p - movable", when("(piece-of ?p ?t) (piece-by ?p ?x) (" + name + " ?t)", "(" + name + " ?p)")));
    add(ActionType::Slice, "", "?x - movable ?t - movable",
        {"(held ?x)", "(cuts ?x ?t)", "(near ?t)", "(free ?t)", "(not (sliced ?t))"}, std::move(cuts));
    const std::string emptied = becomes(Predicate::Empty, "?x") + " (not (filled-with ?x ?s))";
    add(ActionType::PourTo, "", "?x - movable ?t - thing ?s - substance",
        {"(held ?x)", "(filled-with ?x ?s)", "(near ?t)", "(free ?t)", "(fillable ?t)", "(not (filled ?t))",
         "(not (drains ?t ?x))"},
        {emptied, becomes(Predicate::Filled, "?t"), "(filled-with ?t ?s)"});
    add(ActionType::PourTo, "-away", "?x - movable ?t - thing ?s - substance",
        {"(held ?x)", "(filled-with ?x ?s)", "(near ?t)", "(free ?t)", "(drains ?t ?x)"}, {emptied});
    for (auto& direct : direct_actions(offered_)) actions_.push_back(std::move(direct));
    const Lines cleans = {"(not (stained ?t))", for_all("?q - substance", "(not (covered-with ?t ?q))"),
                          when("(dirty ?t)", becomes(Predicate::Clean, "?t"))};
    add(ActionType::Wipe, "", "?x - movable ?t - thing",
        {"(held ?x)", "(wipes ?x ?t)", "(near ?t)", "(free ?t)", "(not (dry ?x))"}, cleans);
    add(ActionType::Wipe, "-dry", "?x - movable ?t - thing",
        {"(held ?x)", "(wipes ?x ?t)", "(near ?t)", "(free ?t)", "(dry ?x)", "(not (dirty ?t))", "(not (stained ?t))"},
        {for_all("?q - substance", "(not (covered-with ?t ?q))")});
    add(ActionType::SpreadTo, "", "?x - movable ?t - thing ?s - substance",
        {"(held ?x)", "(dispenses ?x ?t ?s)", "(near ?t)", "(free ?t)"},
        {"(covered-with ?t ?s)", when("(staining ?s)", "(stained ?t)")});
  }

  /// ?x is put to the tool ?t, treated and taken back; what else is there is treated too.
  void add_composite(const ProcessClass& process) {
    const auto action = action_for(process.treatment);
    if (!action || !has(*action)) return;
    const bool fills = process.treatment == Treatment::Fills;
    // Monitors have to see each moment of it, so that where there are any it is done step by step.
    Lines needs = {"(not (watching))", "(held ?x)", "(" + name_of(process) + " ?t ?x" + (fills ? " ?u)" : ")"),
                   "(near ?t)", "(free ?t)"};
    const auto place = process.tap || process.place == Place::Inside ? Place::Inside : Place::On;
    // A door that has to open on the way opens only while the tool is off; what is open already may stay so.
    if (process.door) needs.emplace_back(process.closed ? "(not (power_on ?t))" : "(or (not (power_on ?t)) (open ?t))");
    // What runs only shut is not switched on with its door open, as it is for all that goes inside.
    if (process.door && process.power && !process.closed) {
      needs.emplace_back(place == Place::Inside ? "(or (not (shuts-to-run ?t)) (power_on ?t))"
                                                : "(or (not (shuts-to-run ?t)) (power_on ?t) (not (open ?t)))");
    }
    if (process.treatment == Treatment::Freezes) needs.emplace_back("(not (can-cool ?t ?x))");
    const auto yes = [](bool known) { return known ? std::optional(true) : std::nullopt; };
    Lines effects;
    run_on_content(processes_, {yes(process.closed), yes(process.power), process.tap}, effects);
    auto shut = std::optional(process.closed);
    if (process.door && !process.closed && place == Place::On) shut.reset();  // the door stays as it is
    run_on_new(processes_, {shut, yes(process.power), process.tap}, place, effects);
    const auto name = composite_name(process).substr(info(*action).name.size());
    add(*action, name, std::string("?x - movable ?t - thing") + (fills ? " ?u - substance" : ""), std::move(needs),
        std::move(effects));
  }

  ActionSet offered_;
  const std::vector<ProcessClass>& processes_;
  std::vector<ActionText> actions_;
};

}  // namespace

std::string composite_name(const ProcessClass& process) {
  const auto action = action_for(process.treatment);
  return action ? std::string(info(*action).name) + "-" + name_of(process) : "";
}

std::vector<ActionText> actions_of(const ActionSet& offered, const std::vector<ProcessClass>& processes) {
  return ActionWriter(offered, processes).write();
}

}  // namespace unietp::pddl
