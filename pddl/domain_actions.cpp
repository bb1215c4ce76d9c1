#include "pddl/action_rows.h"
#include "pddl/domain.h"
#include "scene/action_table.h"

namespace unietp::pddl {
namespace {

using Place = ProcessClass::Place;

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
    add_direct();
    for (const auto& process : processes_) add_composite(process);
    return std::move(actions_);
  }

 private:
  bool has(ActionType type) const { return offered_[static_cast<std::size_t>(type)]; }
  Lines needs_of(ActionType type, ActionRule rule, bool in_hand = false) const {
    return row_needs(info(type), has(ActionType::StandUp), rule, in_hand);
  }
  /// Adds an action, or with `suffix` a case of it, with what its row needs and changes, and more.
  void add(ActionType type, const std::string& suffix, const std::string& parameters, const Lines& needs = {},
           const Lines& effects = {}, bool in_hand = false) {
    const ActionInfo& row = info(type);
    if (!has(type)) return;
    actions_.push_back({std::string(row.name) + suffix, parameters,
                        joined(needs_of(type, ActionRule::Always, in_hand), needs), joined(row_effects(row), effects)});
  }

  void add_going() {
    // To what stands on the floor; with it to all that rests on it.
    add(ActionType::GoTo, "", "?f - thing ?r - room", {"(standing ?f)", "(in_room ?f ?r)"},
        {"(agent-in ?r)", for_all("?q - room", when("(not (= ?q ?r))", "(not (agent-in ?q))")),
         for_all("?w - thing", when("(rests ?w ?f)", "(near ?w)")),
         for_all("?w - thing", when("(not (rests ?w ?f))", "(not (near ?w))"))});
    add(ActionType::GoTo, "-room", "?r - room", {},
        {"(agent-in ?r)", for_all("?q - room", when("(not (= ?q ?r))", "(not (agent-in ?q))")),
         for_all("?w - thing", "(not (near ?w))")});
    add(ActionType::StandUp, "", "", {},
        {"(not (seated))", for_all("?t - thing", "(and (not (sat_on ?t)) (not (lain_on ?t)))")});
  }

  void add_moving() {
    add(ActionType::PickUp, "", "?t - movable");
    const auto put = [&](ActionType type, Place place, const Moment& moment) {
      Lines treats;
      run_on_content(processes_, moment, treats);
      run_on_new(processes_, moment, place, treats);
      add(type, "", "?x - movable ?t - thing", {}, treats);
    };
    put(ActionType::PlaceOn, Place::On, {});
    put(ActionType::PlaceIn, Place::Inside, {false, {}, false});
    add(ActionType::Drop, "", "?x - movable ?r - room", {"(agent-in ?r)"});
  }

  void add_doors() {
    Lines opens = {for_all("?w - thing", when("(shut ?w ?t)", "(not (shut ?w ?t)) (free ?w)"))};
    run_on_content(processes_, {false, {}, false}, opens);
    // No action bears the name of a predicate: some tools keep one list of names.
    add(ActionType::Open, "-shut", "?t - thing", needs_of(ActionType::Open, ActionRule::OpenNeedsPowerOff), opens);
    Lines closes = {for_all("?w - thing", when("(inside ?w ?t) (free ?w)", "(shut ?w ?t) (not (free ?w))"))};
    run_on_content(processes_, {true, {}, false}, closes);
    add(ActionType::Close, "", "?t - thing", {}, closes);
  }

  void add_power() {
    Lines on, off;
    run_on_content(processes_, {{}, true, false}, on);
    run_on_content(processes_, {{}, false, false}, off);
    const auto plugged = has(ActionType::PlugIn) ? needs_of(ActionType::TurnOn, ActionRule::PowerNeedsPlug) : Lines();
    const auto with_door = joined({"(shuts-to-run ?t)"}, needs_of(ActionType::TurnOn, ActionRule::PowerNeedsClosed));
    const Lines without_door = {"(not (shuts-to-run ?t))"};
    add(ActionType::TurnOn, "", "?t - thing", joined(without_door, plugged), on);
    add(ActionType::TurnOn, "-shut", "?t - thing", joined(with_door, plugged), on);
    add(ActionType::TurnOn, "-held", "?t - movable", joined(without_door, plugged), on, true);
    add(ActionType::TurnOff, "", "?t - thing", {}, off);
    add(ActionType::TurnOff, "-held", "?t - movable", {}, off, true);
  }

  /// The actions with what the hand holds. Two have two cases, by what the target is.
  void add_contents() {
    add(ActionType::Slice, "", "?x - movable ?t - movable");
    add(ActionType::PourTo, "", "?x - movable ?t - thing ?s - substance",
        joined(needs_of(ActionType::PourTo, ActionRule::TargetFills), {"(not (drains ?t ?x))"}),
        row_effects(info(ActionType::PourTo), ActionRule::TargetFills));
    add(ActionType::PourTo, "-away", "?x - movable ?t - thing ?s - substance", {"(drains ?t ?x)"});
    add(ActionType::Wipe, "", "?x - movable ?t - thing", needs_of(ActionType::Wipe, ActionRule::TargetStained));
    add(ActionType::Wipe, "-dry", "?x - movable ?t - thing", {"(dry ?x)", "(not (dirty ?t))", "(not (stained ?t))"});
    add(ActionType::SpreadTo, "", "?x - movable ?t - thing ?s - substance");
  }

  void add_direct() {
    for (const ActionInfo& action : action_table()) {
      if (!action.direct || action.starts_tool) continue;
      const bool held = asks(action, ActionNeed::Kind::InHand);
      if (!held) add(action.type, "", "?t - thing");
      if (held || asks(action, ActionNeed::Kind::ReachOrInHand))
        add(action.type, "-held", "?t - movable", {}, {}, true);
    }
  }

  /// ?x is put to the tool ?t, treated and taken back; what else is there is treated too.
  void add_composite(const ProcessClass& process) {
    const auto action = action_for(process.treatment);
    if (!action || !has(*action)) return;
    const bool fills = process.treatment == Treatment::Fills;
    // Monitors have to see each moment of it, so that where there are any it is done step by step.
    Lines needs = {"(not (watching))", "(" + name_of(process) + " ?t ?x" + (fills ? " ?u)" : ")")};
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
    add(*action, name, std::string("?x - movable ?t - thing") + (fills ? " ?u - substance" : ""), needs, effects);
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
