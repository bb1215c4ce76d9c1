#include "exports/release_goal.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "exports/release_binder.h"
#include "exports/release_words.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;
using Op = Formula::Op;

constexpr const char* kTheirAgent = "robot_agent";

class ReleaseTranslator {
 public:
  ReleaseTranslator(const Scene& start, const Knowledge& knowledge, const FormatFacts& facts)
      : knowledge_(knowledge), binder_(start, knowledge, facts) {}

  Result<ReleaseGoal> run(const Formula& goal) {
    const Json logic = node(goal);
    binder_.check_referents(for_all_ || compares_);
    if (!binder_.why().empty()) return Error{Error::Kind::Unsatisfiable, "", {}, binder_.why()};
    return ReleaseGoal{logic.dump(), binder_.referents()};
  }

 private:
  Json refuse(const std::string& why) {
    binder_.refuse(why);
    return Json();
  }

  Json node(const Formula& f) {
    switch (f.op) {
      case Op::Atom:
        return atom(f);
      case Op::Equal:
        return refuse("their goals cannot compare objects");
      case Op::And:
      case Op::Or: {
        if (f.children.empty()) return refuse("their And and Or must not be empty");
        Json children = Json::array();
        for (const Formula& child : f.children) children.push_back(node(child));
        return {{"type", f.op == Op::And ? "And" : "Or"}, {"children", std::move(children)}};
      }
      case Op::Not:
        return unary("Not", f.children[0]);
      case Op::Imply:
        return {{"type", "Implies"}, {"premise", node(f.children[0])}, {"conclusion", node(f.children[1])}};
      case Op::Forall:
      case Op::Exists:
      case Op::Count:
        return quantified(f);
      case Op::CountCompare: {
        compares_ = true;
        Json left = counting(f.children[0]), right = counting(f.children[1]);
        return {{"type", "Compare"}, {"left", std::move(left)}, {"op", symbol(f)}, {"right", std::move(right)}};
      }
      case Op::AtEnd:
        return temporal("AtEnd", f.children[0], true);
      case Op::Sometime:
        return temporal("Sometime", f.children[0], false);
      case Op::Always:
        return temporal("Always", f.children[0], false);
      case Op::Until:
      case Op::Before:
        return ordered(f);
      case Op::Number:
        break;  // only below CountCompare
    }
    return refuse("a number alone");
  }

  Json unary(const char* type, const Formula& child) { return {{"type", type}, {"child", node(child)}}; }

  Json temporal(const char* type, const Formula& child, bool at_end) {
    const bool outer = at_end_;
    at_end_ = at_end;
    Json json = unary(type, child);
    at_end_ = outer;
    return json;
  }

  /// Theirs forgives a late `pre` and a `succ` that never comes; ours is said with Until and Sometime.
  Json ordered(const Formula& f) {
    const bool outer = at_end_;
    at_end_ = false;
    Json first = node(f.children[0]), second = node(f.children[1]);
    at_end_ = outer;
    if (f.op == Op::Until) return {{"type", "Until"}, {"cond_a", std::move(first)}, {"cond_b", std::move(second)}};
    const Json not_yet{{"type", "Not"}, {"child", second}};
    const Json now{{"type", "And"}, {"children", Json::array({std::move(first), not_yet})}};
    const Json in_order{{"type", "Until"}, {"cond_a", not_yet}, {"cond_b", now}};
    const Json comes{{"type", "Sometime"}, {"child", std::move(second)}};
    return {{"type", "And"}, {"children", Json::array({in_order, comes})}};
  }

  static std::string symbol(const Formula& f) {
    return f.comparison == Comparison::Equal ? "==" : std::string(symbol_of(f.comparison));
  }

  /// What is born later is counted by them among what exists at the step at hand, so only at the end.
  Json quantified(const Formula& f) {
    const auto& members = f.domain.members;
    const bool late = std::any_of(members.begin(), members.end(), [&](const Domain::Member& member) {
      return member.slice || binder_.made_by_cutting(member.category);
    });
    if (f.op != Op::Exists && late && !at_end_ && f.children[0].op == Op::AtEnd) {
      Formula inner = f;
      inner.children[0] = f.children[0].children[0];
      return temporal("AtEnd", inner, true);
    }
    if (f.op == Op::Exists && f.domain.members.size() > 1) {  // theirs takes one category
      Json children = Json::array();
      for (const auto& member : f.domain.members) {
        Formula one = f;
        one.domain.members = {member};
        children.push_back(quantified(one));
      }
      return {{"type", "Or"}, {"children", std::move(children)}};
    }
    if (f.op == Op::Count) {
      compares_ = true;
      return {{"type", "Compare"}, {"left", counting(f)}, {"op", symbol(f)}, {"right", f.number}};
    }
    for_all_ = for_all_ || f.op == Op::Forall;
    return within(f, f.op == Op::Exists ? "Exists" : "ForAll", "child");
  }

  Json counting(const Formula& f) { return within(f, "CountSatisfying", "condition"); }

  Json within(const Formula& f, const char* type, const char* body) {
    auto bound = binder_.bind(f);
    if (!bound) return Json();
    if (f.op != Op::Exists) {
      if (bound->late && !at_end_) return refuse("their quantifiers range over the slices of the current step");
      if (binder_.vanishes(*bound))
        return refuse("their graph loses objects that are cut, so a `forall` or count over them differs");
    }
    Json categories = bound->theirs;
    bound_.push_back(std::move(*bound));
    Json json{{"type", type}, {"var_name", f.variable}, {"var_categories", std::move(categories)}};
    json[body] = node(f.children[0]);
    bound_.pop_back();
    return json;
  }

  const ReleaseBound* bound(const Term& term) const {
    const auto found =
        std::find_if(bound_.rbegin(), bound_.rend(), [&](const ReleaseBound& one) { return one.name == term.name; });
    return found == bound_.rend() ? nullptr : &*found;
  }

  Json atom(const Formula& f) {
    switch (f.predicate) {
      case Predicate::On:
      case Predicate::Inside:
        return on_or_inside(f);
      case Predicate::Held:
        return relation("grasping", kTheirAgent, word(f.terms[0]));
      case Predicate::InRoom:
        if (f.terms[0].kind == Term::Kind::Agent) return relation("inside_room", kTheirAgent, word(f.terms[1]));
        if (!says_rooms_of_objects(knowledge_.simulator()))
          return refuse("their graph does not have the room of every object");
        return from_object("inside_room", f);
      case Predicate::OnFloor:
        if (knowledge_.simulator() != Simulator::Ai2thor)
          return refuse("their graph does not show for every object whether it is on the floor");
        return from_object("on_room_floor", f);
      default:
        return state(f);
    }
  }

  Json on_or_inside(const Formula& f) {
    const bool on = f.predicate == Predicate::On;
    const ReleaseBound* place = bound(f.terms[1]);
    if (place == nullptr) return refuse("a relation to something that is not an object");
    for (const std::string& category : place->ours) {
      const bool has_other = knowledge_.has(category, on ? "container" : "receptacle");
      if (!says_on_and_inside(knowledge_.simulator()) && has_other)
        return refuse("objects can be on and inside " + category + ", but their graph has only one of these");
    }
    return from_object(on ? "on_receptacle" : "inside_receptacle", f);
  }

  /// Their evaluator stops with an error when the first object of a relation does not exist.
  Json from_object(const char* name, const Formula& f) {
    const ReleaseBound* first = bound(f.terms[0]);
    if (first == nullptr) return refuse("a relation of something that is not an object");
    if (first->late && !at_end_) return refuse("their relations fail for slices that do not exist yet");
    if (binder_.vanishes(*first)) return refuse("their relations fail for objects that were cut and disappeared");
    return relation(name, word(f.terms[0]), word(f.terms[1]));
  }

  static Json relation(const char* name, const std::string& from, const std::string& to) {
    return {{"type", "Predicate"},
            {"predicate_type", "relation"},
            {"predicate_kwargs", {{"relation", name}, {"relation_details", nullptr}}},
            {"args", {from, to}}};
  }

  Json state(const Formula& f) {
    const auto name = release_state(knowledge_.simulator(), f.predicate);
    if (!name) return refuse("their graph of this simulator has no `" + std::string(info(f.predicate).name) + "`");
    Json params;
    if (f.terms.size() > 1 && f.terms[1].name != "any") {
      if (f.predicate == Predicate::Covered)
        return refuse("their evaluator compares all substances on an object at once");
      params = {{"liquid_type", f.terms[1].name}};
    }
    return {{"type", "Predicate"},
            {"predicate_type", "state"},
            {"predicate_kwargs", {{"state", *name}, {"state_params", std::move(params)}}},
            {"args", word(f.terms[0])}};
  }

  static std::string word(const Term& term) { return term.kind == Term::Kind::Agent ? kTheirAgent : "?" + term.name; }

  const Knowledge& knowledge_;
  ReleaseBinder binder_;
  std::vector<ReleaseBound> bound_;
  bool at_end_ = false;  // the innermost temporal operator is AtEnd
  bool for_all_ = false, compares_ = false;
};

}  // namespace

Result<ReleaseGoal> release_goal(const Formula& goal, const Scene& start, const Knowledge& knowledge,
                                 const FormatFacts& facts) {
  return ReleaseTranslator(start, knowledge, facts).run(goal);
}

}  // namespace unietp
