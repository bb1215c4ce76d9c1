#include "pddl/action_rows.h"

#include <algorithm>

#include "pddl/domain.h"
#include "scene/states.h"
#include "scene/treatment.h"

namespace unietp::pddl {
namespace {

using Kind = ActionNeed::Kind;

const Lines kLeavesPlace = {
    "(not (standing ?t))",
    for_all("?w - movable", when("(rests ?w ?t)", "(not (near ?w))")),
    for_all("?w - movable ?z - thing", when("(rests ?w ?t) (rests ?t ?z) (not (= ?t ?z))", "(not (rests ?w ?z))")),
    for_all("?w - movable ?z - thing", when("(rests ?w ?t) (inside ?t ?z)", "(not (inside ?w ?z))")),
    for_all("?z - thing", "(not (on ?t ?z))"),
    for_all("?r - room", "(not (on_floor ?t ?r))"),
    for_all("?w - movable ?r - room", when("(rests ?w ?t)", "(not (in_room ?w ?r))")),
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

/// Each piece ?p that ?x cuts off ?t is where ?t is and has its states.
Lines make_pieces() {
  Lines made;
  const auto add = [&made](const std::string& more, const std::string& condition, const std::string& effect) {
    made.push_back(for_all("?p - movable" + more, when("(piece-of ?p ?t) (piece-by ?p ?x)" + condition, effect)));
  };
  const auto copy = [&add](const std::string& name, const std::string& other = "", const std::string& more = "") {
    add(more, " (" + name + " ?t" + other + ")", "(" + name + " ?p" + other + ")");
  };
  add(" ?z - thing", " (rests ?t ?z) (not (= ?t ?z))", "(rests ?p ?z)");
  for (const char* relation : {"inside", "on", "shut"}) copy(relation, " ?z", " ?z - thing");
  for (const char* relation : {"in_room", "on_floor"}) copy(relation, " ?r", " ?r - room");
  for (const char* relation : {"covered-with", "filled-with"}) copy(relation, " ?q", " ?q - substance");
  add("", "", "(present ?p) (free ?p)");
  add("", " (not (standing ?t))", "(near ?p)");
  for (const char* state : {"standing", "stained"}) copy(state);
  for (const auto& group : state_groups()) {
    for (const auto state : group.predicates) {
      if (state != Predicate::Whole && state != Predicate::Sliced) copy(std::string(info(state).name));
    }
  }
  return made;
}

std::string fact(Predicate state, const std::string& thing) {
  return "(" + std::string(info(state).name) + " " + thing + ")";
}
std::string no(const std::string& fact) { return "(not " + fact + ")"; }

/// What the tool in the hand has to be for ?t.
std::string tool_fact(ActionType action) {
  for (const TreatmentInfo& row : all_treatments()) {
    if (row.by_hand != action) continue;
    if (row.treatment == Treatment::Slices) return "(cuts ?x ?t)";
    return "(" + std::string(row.name) + " ?x ?t" + (row.treatment == Treatment::Dispenses ? " ?s)" : ")");
  }
  return "";
}

/// Whether the other needs say that the target is in one of the states of this one's group.
bool has_group_of(const ActionInfo& action, Predicate state) {
  return std::any_of(action.needs.begin(), action.needs.end(), [state](const ActionNeed& need) {
    return (need.kind == Kind::Varies && info(need.state).group == info(state).group) ||
           (need.kind == Kind::Affordance && need.affordance == info(state).group);
  });
}

/// "" for what PDDL leaves out, or what another need says already.
std::string text_of(const ActionInfo& action, const ActionNeed& need, bool seats, bool in_hand) {
  switch (need.kind) {
    case Kind::Affordance:  // the fact about a tool has it in it
      return asks(action, Kind::HeldTool) ? "" : "(" + std::string(need.affordance) + " ?t)";
    case Kind::Is:
      return fact(need.state, "?t");
    case Kind::IsNot: {  // where it is in another state of the group then: no negation for planners
      const auto other = opposite_of(need.state);
      return other && has_group_of(action, need.state) ? fact(*other, "?t") : no(fact(need.state, "?t"));
    }
    case Kind::InHand:
      return "(held ?t)";
    case Kind::HandFree:
      return "(hand-empty)";
    case Kind::Holding:
      return "(held ?x)";
    case Kind::HeldIs:
      return need.state == Predicate::Filled ? "(filled-with ?x ?s)" : fact(need.state, "?x");
    case Kind::HeldIsNot:
      return no(fact(need.state, "?x"));
    case Kind::HeldTool:
      return tool_fact(action.type);
    case Kind::Fits:
      return need.state == Predicate::On ? "(fits-on ?x ?t)" : "(fits-in ?x ?t)";
    case Kind::ReachOrInHand:
      return in_hand ? "(held ?t)" : "(near ?t) (free ?t)";
    case Kind::Reach:
      return "(near ?t) (free ?t)";
    case Kind::Unloaded:
      return "(forall (?w - movable) (or (= ?w ?t) (not (rests ?w ?t))))";
    case Kind::Standing:
      return seats ? "(not (seated))" : "";
    case Kind::Seated:
      return "(seated)";
    case Kind::NotSeat:
      return seats ? "(not (sat_on ?t)) (not (lain_on ?t))" : "";
    case Kind::Varies:
    case Kind::NotInHand:
    case Kind::NotCarried:
    case Kind::TargetTool:
    case Kind::Sight:
    case Kind::Special:
      break;
  }
  return "";
}

Lines effects_of(const ActionChange& change) {
  const bool held = change.of == ActionChange::Of::Held;
  const std::string thing = held ? "?x" : "?t";
  auto text = becomes(change.state, thing);
  if (change.only_if) text = when(fact(*change.only_if, thing), text);
  switch (change.state) {
    case Predicate::Held:
      return joined({text, "(not (hand-empty))"}, kLeavesPlace);
    case Predicate::On:
      return joined({"(on ?x ?t)"}, kComesToPlace);
    case Predicate::Inside:
      return joined({for_all("?w - movable", when("(rests ?w ?x)", "(inside ?w ?t)"))}, kComesToPlace);
    case Predicate::OnFloor:
      return {"(not (held ?x))", "(hand-empty)", "(standing ?x)", "(on_floor ?x ?r)",
              for_all("?w - movable", when("(rests ?w ?x)", "(in_room ?w ?r)"))};
    case Predicate::Sliced:
      return joined({text}, make_pieces());
    case Predicate::Covered:
      if (change.ends) return {"(not (stained ?t))", for_all("?q - substance", "(not (covered-with ?t ?q))")};
      return {"(covered-with ?t ?s)", when("(staining ?s)", "(stained ?t)")};
    case Predicate::Filled:
      return {text, "(filled-with " + thing + " ?s)"};
    case Predicate::Empty:
      return {text, held ? "(not (filled-with ?x ?s))" : for_all("?s - substance", "(not (filled-with ?t ?s))")};
    case Predicate::SatOn:
    case Predicate::LainOn:
      return {text, "(seated)"};
    default:
      return {text};
  }
}

}  // namespace

Lines joined(Lines first, const Lines& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}
std::string when(const std::string& condition, const std::string& effects) {
  return "(when (and " + condition + ") (and " + effects + "))";
}
std::string for_all(const std::string& variables, const std::string& effect) {
  return "(forall (" + variables + ") " + effect + ")";
}

bool asks(const ActionInfo& action, ActionNeed::Kind kind) {
  return std::any_of(action.needs.begin(), action.needs.end(),
                     [kind](const ActionNeed& need) { return need.kind == kind; });
}

Lines row_needs(const ActionInfo& action, bool seats, ActionRule rule, bool in_hand) {
  Lines needs;
  for (const ActionNeed& need : action.needs) {
    if (need.rule != rule) continue;
    if (auto text = text_of(action, need, seats, in_hand); !text.empty()) needs.push_back(std::move(text));
  }
  return needs;
}

Lines row_effects(const ActionInfo& action, ActionRule rule) {
  Lines effects;
  for (const ActionChange& change : action.changes) {
    if (change.rule == rule) effects = joined(std::move(effects), effects_of(change));
  }
  return effects;
}

}  // namespace unietp::pddl
