#include "exports/bddl_goal.h"

#include <algorithm>
#include <set>

#include "core/text.h"
#include "logic/evaluate.h"
#include "scene/trace.h"

namespace unietp {
namespace {

using Op = Formula::Op;

class Translator {
 public:
  Translator(const Scene& start, const Knowledge& knowledge, const BddlWords& words,
             const std::map<std::string, std::string>& names)
      : start_(start), knowledge_(knowledge), words_(words), liquids_(liquids_of(start, knowledge)), names_(names) {}

  Result<BddlGoal> run(const Formula& goal) {
    const std::string text = node(goal);
    if (!why_.empty()) return Error{Error::Kind::Unsatisfiable, "", {}, why_};
    return BddlGoal{text, {categories_.begin(), categories_.end()}, substances_};
  }

 private:
  std::string refuse(const std::string& why) {
    if (why_.empty()) why_ = why;
    return "";
  }

  std::string node(const Formula& f) {
    switch (f.op) {
      case Op::Atom:
        return atom(f);
      case Op::And:
      case Op::Or:
        return f.children.empty() ? refuse("an empty conjunction or disjunction")
                                  : list(f.op == Op::And ? "and" : "or", f.children);
      case Op::Not:
        return list("not", f.children);
      case Op::Imply:
        return list("imply", f.children);
      case Op::AtEnd:
        return at_end(f);
      case Op::Forall:
      case Op::Exists:
      case Op::Count:
        return quantified(f);
      case Op::Equal:
        return refuse("BDDL cannot compare objects");
      case Op::Number:
      case Op::CountCompare:
        return refuse("BDDL cannot compare numbers of objects");
      case Op::Sometime:
      case Op::Always:
      case Op::Until:
      case Op::Before:
        return refuse("BDDL evaluates only the last state");
    }
    return "";
  }

  std::string list(const std::string& word, const std::vector<Formula>& parts) {
    std::string text = "(" + word;
    for (const Formula& part : parts) text += " " + node(part);
    return text + ")";
  }

  std::string at_end(const Formula& f) {
    if (at_end_) return node(f.children[0]);
    at_end_ = true;
    std::string text = node(f.children[0]);
    at_end_ = false;
    return text;
  }

  std::string quantified(const Formula& f) {
    if (f.domain.kind != Domain::Kind::Categories || f.domain.members.size() != 1)
      return refuse("a BDDL quantifier ranges over objects of one synset");
    const auto& member = f.domain.members[0];
    if (knowledge_.find(member.category) == nullptr) return refuse("rooms are not objects in BDDL");
    if (member.slice) return refuse("slices that do not exist at the start");
    const auto synset = words_.categories.find(member.category);
    if (synset == words_.categories.end()) return refuse(member.category + " has no synset");
    bool alone = true;  // the synset is no more than the category here
    for (const Node& other : start_.nodes) {
      for (const Effect* cut : knowledge_.effects_on(other.category, Treatment::Slices)) {
        if (cut->gives == member.category) return refuse("slices that do not exist at the start");
      }
      const auto its = words_.categories.find(other.category);
      alone = alone &&
              (other.category == member.category || its == words_.categories.end() || its->second != synset->second);
    }
    categories_.insert(member.category);
    if (!f.domain.where.empty() || !alone) return over_named(f);
    const std::string body_of = "(?" + f.variable + " - " + synset->second + ") ";
    values_[f.variable] = "?" + f.variable;
    const std::string body = node(f.children[0]);
    values_.erase(f.variable);
    if (f.op == Op::Count) return counted(f, body_of + body, member.category);
    return "(" + std::string(f.op == Op::Exists ? "exists " : "forall ") + body_of + body + ")";
  }

  /// `forn` says exactly so many.
  std::string counted(const Formula& f, const std::string& rest, const std::string& category) const {
    const auto there = static_cast<int>(
        std::count_if(start_.nodes.begin(), start_.nodes.end(), [&](const Node& n) { return n.category == category; }));
    int low = 0, high = there;
    if (f.comparison == Comparison::Equal) low = high = f.number;
    if (f.comparison == Comparison::AtLeast) low = f.number;
    if (f.comparison == Comparison::Greater) low = f.number + 1;
    if (f.comparison == Comparison::AtMost) high = std::min(high, f.number);
    if (f.comparison == Comparison::Less) high = std::min(high, f.number - 1);
    std::vector<std::string> exactly;
    for (int n = low; n <= high; ++n) exactly.push_back("(forn (" + std::to_string(n) + ") " + rest + ")");
    if (exactly.empty()) exactly.push_back("(forn (" + std::to_string(there + 1) + ") " + rest + ")");  // never
    return exactly.size() == 1 ? exactly[0] : "(or " + join(exactly, " ") + ")";
  }

  /// What is meant is known at the start, so each is named.
  std::string over_named(const Formula& f) {
    const auto free = f.domain.where.empty() ? std::vector<std::string>() : free_variables(f.domain.where.front());
    if (std::any_of(free.begin(), free.end(), [&](const auto& name) { return name != f.variable; }))
      return refuse("the referent depends on another object of the goal");
    if (f.op == Op::Count) return refuse("a count over objects without a synset of their own");
    const Trace trace = to_logic(start_, {}, true);
    std::string text;
    for (const EntityIndex entity : members_of(f.domain, f.variable, trace)) {
      values_[f.variable] = "?" + names_.at(trace.entities[entity].id);
      text += " " + node(f.children[0]);
    }
    values_.erase(f.variable);
    return text.empty() ? refuse("there is no referent") : (f.op == Op::Exists ? "(or" : "(and") + text + ")";
  }

  std::string atom(const Formula& f) {
    if (!at_end_) return refuse("BDDL evaluates only the last state");
    const std::string word(info(f.predicate).name);
    if (f.terms[0].kind == Term::Kind::Agent) return refuse("BDDL cannot express where the agent is");
    const std::string first = values_[f.terms[0].name];
    if (f.terms.size() == 1 || f.terms[1].kind == Term::Kind::Symbol) {
      const State state{f.predicate, f.terms.size() == 1 ? "" : f.terms[1].name};
      const std::string text = bddl_state(state, first, words_, liquids_, substances_);
      return text.empty() ? refuse("BDDL cannot express `" + word + "`") : text;
    }
    const auto relation = bddl_relation(f.predicate);
    if (relation.empty()) return refuse("BDDL cannot express `" + word + "`");
    return "(" + std::string(relation) + " " + first + " " + values_[f.terms[1].name] + ")";
  }

  const Scene& start_;
  const Knowledge& knowledge_;
  const BddlWords& words_;
  const std::set<std::string> liquids_;
  const std::map<std::string, std::string>& names_;
  std::map<std::string, std::string> values_;  // of bound variables
  std::set<std::string> categories_, substances_;
  bool at_end_ = false;
  std::string why_;  // the first reason
};

}  // namespace

Result<BddlGoal> bddl_goal(const Formula& goal, const Scene& start, const Knowledge& knowledge, const BddlWords& words,
                           const std::map<std::string, std::string>& names) {
  return Translator(start, knowledge, words, names).run(goal);
}

}  // namespace unietp
