#include "exports/behavior_goal.h"

#include <algorithm>

#include "exports/ltlf_last_state.h"
#include "logic/evaluate.h"
#include "scene/trace.h"

namespace unietp {
namespace {

Error lacks(std::string why) { return {Error::Kind::Unsatisfiable, "", {}, std::move(why)}; }

/// Writes propositions as BDDL.
class LiteralWriter {
 public:
  LiteralWriter(const HalvedTrace& halved, const BddlWords& words, std::set<std::string> liquids,
                const BddlNames& names, const BddlNames& floors)
      : words_(words), liquids_(std::move(liquids)), names_(names), floors_(floors) {
    for (const auto& [whole, halves] : halved.halves) {
      wholes_[whole] = halves;
      owners_[halves.first] = owners_[halves.second] = whole;
    }
  }

  /// Errors: Unsatisfiable, for what BDDL has no word for. `goal` gets what it names.
  Result<std::string> literal(const LtlfProposition& one, BehaviorGoal& goal) const {
    const std::string& id = one.arguments.front();
    if (id == "agent") return lacks("BDDL cannot express where the agent is");
    const auto owner = owners_.find(id);
    const bool is_half = owner != owners_.end();
    goal.objects.insert(is_half ? owner->second : id);
    if (!is_half && !names_.contains(id)) return lacks(id + " has no synset");
    if (one.presence) return real(id);
    const bool is_whole = wholes_.contains(id);
    if (one.meaning == Predicate::Sliced || one.meaning == Predicate::Whole) {
      if (!is_whole) return lacks("BDDL cannot express `" + one.predicate + "` of what is no whole");
      const std::string cut = real(wholes_.at(id).first);
      return one.meaning == Predicate::Sliced ? cut : "(not " + cut + ")";
    }
    if (one.meaning == Predicate::SliceOf) {
      if (!is_half) return lacks("BDDL cannot express `slice_of` of what was cut before");
      return owner->second == one.arguments[1] ? real(id) : "(and " + real(id) + " (not " + real(id) + "))";
    }
    // What is asked of a whole is asked of its first half once it is cut.
    std::vector<std::string> bearers{id};
    if (is_whole) bearers.push_back(wholes_.at(id).first);
    bool negated = false;
    std::string text;
    std::size_t count = 0;
    for (const std::string& bearer : bearers) {
      for (std::string part : parts(one, bearer, goal)) {
        if (part.empty()) return lacks("BDDL cannot express `" + one.predicate + "`");
        negated = part.starts_with("(not ");
        if (negated) part = part.substr(5, part.size() - 6);
        text += " " + part;
        ++count;
      }
    }
    text = count == 1 ? text.substr(1) : "(or" + text + ")";
    if (negated) text = "(not " + text + ")";
    return is_half && negated ? "(and " + real(id) + " " + text + ")" : text;
  }

 private:
  std::string name_of(const std::string& id) const { return "?" + names_.at(id); }
  std::string real(const std::string& id) const { return "(real " + name_of(id) + ")"; }

  /// The literals of which one is asked of a bearer; with an empty one where BDDL has no word.
  std::vector<std::string> parts(const LtlfProposition& one, const std::string& bearer, BehaviorGoal& goal) const {
    const auto unary = [&](const std::string& symbol) {
      return bddl_state({one.meaning, symbol}, name_of(bearer), words_, liquids_, goal.substances);
    };
    if (one.arguments.size() == 1) return {unary("")};
    if (one.entities.size() == 1) return {unary(one.arguments[1])};
    if (one.meaning == Predicate::OnFloor) {
      const auto floor = floors_.find(one.arguments[1]);
      if (floor == floors_.end()) return {""};
      goal.floors.insert(one.arguments[1]);
      return {"(ontop " + name_of(bearer) + " ?" + floor->second + ")"};
    }
    const std::string relation(bddl_relation(one.meaning));
    if (relation.empty() || !(names_.contains(one.arguments[1]))) return {""};
    std::vector<std::string> made;
    std::vector<std::string> others{one.arguments[1]};
    const auto owner = owners_.find(others.front());
    goal.objects.insert(owner == owners_.end() ? others.front() : owner->second);
    if (const auto whole = wholes_.find(others.front()); whole != wholes_.end()) others.push_back(whole->second.first);
    for (const std::string& other : others)
      made.push_back("(" + relation + " " + name_of(bearer) + " " + name_of(other) + ")");
    return made;
  }

  const BddlWords& words_;
  const std::set<std::string> liquids_;
  const BddlNames& names_;
  const BddlNames& floors_;
  std::map<std::string, Halves> wholes_;
  std::map<std::string, std::string> owners_;  // the whole of each half
};

bool is_presence(const std::string& proposition) { return proposition.starts_with("exists_"); }

/// The first states of a trace.
Trace beginning(const Trace& trace, std::size_t states) {
  return {trace.entities, {trace.states.begin(), trace.states.begin() + static_cast<std::ptrdiff_t>(states)}};
}

}  // namespace

Result<BehaviorGoal> behavior_goal(const FinishedTask& task, const Knowledge& knowledge, const BddlWords& words,
                                   const BddlNames& names, const BddlNames& floors) {
  const Formula& tree = task.record.goal_tree;
  const HalvedTrace halved = halved_trace(task, knowledge);
  const std::vector<Delta> changes = changes_by_moment(task.shown.at(Mode::M1));
  if (!halved.halves.empty()) {
    const Trace ours = to_logic(task.start, changes, reads_comparisons(tree));
    for (std::size_t n = 1; n <= ours.states.size(); ++n) {
      if (holds(tree, beginning(ours, n)) != holds(tree, beginning(halved.trace, n)))
        return lacks("OmniGibson cuts a thing in two, and its goal counts only one of the halves");
    }
  }
  Facts front = halved.trace.states.front(), later = front;
  for (std::size_t i = 0; i < halved.trace.entities.size(); ++i) {
    const bool is_object = halved.trace.entities[EntityIndex(i)].kind == Entity::Kind::Object;
    if (is_object) later.set_exists(EntityIndex(i));
  }
  auto grounded = ltlf_goal(tree, Trace{halved.trace.entities, {std::move(front), std::move(later)}});
  if (!grounded) return grounded.error();
  BehaviorGoal made;
  made.goal = std::move(*grounded);
  const LiteralWriter writer(halved, words, liquids_of(task.start, knowledge), names, floors);
  for (const LtlfProposition& one : made.goal.propositions) {
    auto literal = writer.literal(one, made);
    if (!literal) return literal.error();
    made.literals[one.name] = std::move(*literal);
  }
  for (const Facts& facts : halved.trace.states) {
    made.holding.emplace_back();
    for (const LtlfProposition& one : made.goal.propositions) {
      if (one.holds_in(facts)) made.holding.back().push_back(one.name);
    }
  }
  auto last = last_state_of(made.goal.formula, made.literals, is_presence);
  if (last.text == "true" || last.text == "false") return lacks("its goal asks nothing of the last state");
  made.last = std::move(last.text);
  made.last_decides = last.decides;
  return made;
}

}  // namespace unietp
