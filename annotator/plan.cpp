#include "annotator/plan.h"

#include <algorithm>
#include <optional>

#include "annotator/clause_plan.h"
#include "annotator/conditions.h"
#include "annotator/idioms.h"
#include "annotator/meaning.h"
#include "annotator/phrase_plan.h"
#include "annotator/plan_proposition.h"
#include "scene/action.h"
#include "scene/states.h"

namespace unietp {
namespace {

using Op = Formula::Op;

class Planner {
 public:
  Planner(const std::vector<Formula>& start, PlanOptions options, Rng rng)
      : choosing_(options.choosing), everyday_(options.everyday), rng_(rng), phrases_(start, options.home) {
    if (options.conditions) conditions_ = conditions_of(start);
  }

  /// The whole goal as one proposition.
  Result<Plan> exactly(const Formula& goal) {
    state(goal, {});
    if (phrases_.error()) return *phrases_.error();
    return std::move(plan_);
  }

  Result<Plan> plan(const Formula& goal) {
    Formula body = goal;
    while (body.op == Op::Exists) {
      phrases_.scope()[body.variable] = body.domain;
      Formula inner = body.children[0];
      body = std::move(inner);
    }
    std::vector<Formula> parts = body.op == Op::And ? body.children : std::vector<Formula>{body};
    std::vector<Formula> finals, others;
    for (const Formula& part : parts) {
      if (part.op == Op::Not && part.children[0].op == Op::Equal) {
        const std::string &a = part.children[0].terms[0].name, &b = part.children[0].terms[1].name;
        plan_.distinct.insert({a, b});
        plan_.distinct.insert({b, a});
      } else if (only_at_end(part)) {
        finals.push_back(without_at_end(part));
      } else {
        others.push_back(part);
      }
    }
    std::vector<Requirement> early, late;
    std::vector<Formula> stated;  // what no clause expresses
    for (const Formula& part : others)
      if (!add_temporal(part, finals, part.op == Op::Always ? late : early)) stated.push_back(part);
    std::vector<Clause> clauses;
    for (const Formula& part : finals) {
      Clause said = planned_clause(part, phrases_);
      if (phrases_.clear_error()) {
        stated.push_back(at_end(part));
      } else {
        clauses.push_back(std::move(said));
      }
    }
    if (everyday_) join_idioms(clauses);
    if (everyday_ || rng_.chance(0.8)) join_subjects(clauses);
    if (everyday_) order_as_done(clauses);
    plan_.message = std::move(early);
    for (Clause& said : clauses) plan_.message.push_back({Requirement::Kind::Final, {std::move(said)}, false, {}});
    for (Requirement& requirement : late) plan_.message.push_back(std::move(requirement));
    for (const Formula& part : stated) state(gathered(part), free_variables(part));
    if (plan_.message.empty()) fail(goal);
    if (phrases_.error()) return *phrases_.error();
    if (choosing_ && rng_.chance(0.5)) choose_first();
    for (const Formula& f : conditions_) add_condition(f);
    rng_.shuffle(plan_.conditions);
    return std::move(plan_);
  }

 private:
  void fail(const Formula& part) { phrases_.fail(part); }

  void state(const Formula& part, const std::vector<std::string>& about) {
    Clause named;
    for (const std::string& variable : about) named.subjects.push_back(phrases_.reference(variable, part));
    plan_.message.push_back({Requirement::Kind::Stated, {std::move(named)}, false, {proposition_of(part, phrases_)}});
  }

  /// Adds a condition if it is a positive statement.
  void add_condition(const Formula& condition) {
    NounPhrase phrase;
    phrase.noun = condition.domain;
    phrase.noun.where.clear();
    const Formula where = expanded(condition.domain.where[0]);
    for (const Formula& part : PhrasePlanner::scattered(where, condition.variable)) {
      if (part.op != Op::Atom && part.op != Op::Exists) return;
      const auto said = phrases_.complement(part, condition.variable, Determiner::New);
      if (!said) return;
      phrase.modifiers.push_back(*said);
    }
    if (!phrase.modifiers.empty()) plan_.conditions.push_back(std::move(phrase));
  }

  static std::vector<Formula> conjuncts(const Formula& f) {
    return f.op == Op::And ? f.children : std::vector<Formula>{f};
  }

  /// Takes the conjuncts of `f` out of `finals` when all are there.
  static bool take(const Formula& f, std::vector<Formula>& finals) {
    for (const Formula& part : conjuncts(f))
      if (std::find(finals.begin(), finals.end(), part) == finals.end()) return false;
    for (const Formula& part : conjuncts(f)) finals.erase(std::find(finals.begin(), finals.end(), part));
    return true;
  }

  /// Adds a temporal formula together with the `finals` that belong to it. False, without changes, when no clause can
  /// express it.
  bool add_temporal(const Formula& f, std::vector<Formula>& finals, std::vector<Requirement>& out) {
    using Kind = Requirement::Kind;
    const auto say = [&](Kind kind, std::vector<Clause> clauses) {
      if (phrases_.clear_error()) return false;
      out.push_back({kind, std::move(clauses), false, {}});
      return true;
    };
    const auto said = [&](std::size_t i) { return planned_clause(f.children[i], phrases_); };
    switch (f.op) {
      case Op::Always:
        return say(Kind::Always, {said(0)});
      case Op::Until:
        if (everyday_ && say_until(f, finals, out)) return true;
        return say(Kind::Until, {said(0), said(1)});
      case Op::Sometime: {
        const auto undone = std::find_if(finals.begin(), finals.end(),
                                         [&](const Formula& part) { return opposite(f.children[0], part); });
        const auto meanwhile = [&](const Formula& part) {
          return !(part == *undone) && mentions(part, f.children[0].terms[0].name);
        };
        if (everyday_ && undone != finals.end()) return reopened(f.children[0], undone - finals.begin(), finals, out);
        if (undone == finals.end() || rng_.chance(0.3) || std::any_of(finals.begin(), finals.end(), meanwhile)) {
          // Taking something out of a fridge comes before closing it.
          if (undone != finals.end()) std::rotate(undone, undone + 1, finals.end());
          return say(Kind::Sometime, {said(0)});
        }
        const bool found = say(Kind::Again, {said(0), planned_clause(*undone, phrases_)});
        if (found) finals.erase(undone);
        return found;
      }
      case Op::Before: {
        const bool apart = rng_.chance(0.25);
        std::vector<Clause> clauses{said(0), said(1)};
        if (phrases_.clear_error()) return false;
        std::vector<Formula> rest = finals;
        const bool ends = take(f.children[1], rest), kept = ends && take(f.children[0], rest);
        if (everyday_ && ends && !kept) from_the_first(f, rest, clauses);
        if (!ends || (apart && !everyday_)) return say(Kind::Before, std::move(clauses));
        finals = std::move(rest);
        return say(kept ? Kind::ThenKept : Kind::Then, std::move(clauses));
      }
      default:
        return false;
    }
  }

  /// "Fill the pot with water, then pour it into a vase.", "Slice a potato, then cook one of the slices."
  void from_the_first(const Formula& f, std::vector<Formula>& finals, std::vector<Clause>& clauses) {
    const Formula &first = f.children[0], &then = f.children[1];
    if (first.op != Op::Atom || then.op != Op::Atom || first.terms[0] == then.terms[0]) return;
    if (first.predicate == Predicate::Filled && then.predicate == Predicate::Filled)
      clauses[1].poured = first.terms[1] == then.terms[1];
    Formula cut;
    cut.op = Op::Atom;
    cut.predicate = Predicate::SliceOf;
    cut.terms = {then.terms[0], first.terms[0]};
    if (first.predicate != Predicate::Sliced || !take(cut, finals)) return;
    clauses[1].subjects[0].done.push_back({Predicate::SliceOf, false, "", {clauses[0].subjects[0]}});
  }

  /// Takes out of `finals` what means the same as `f`, whatever its variables are called.
  static bool take_alike(const Formula& f, std::vector<Formula>& finals) {
    const auto alike = [&](const Formula& part) { return same_expanded(part, f); };
    const auto found = std::find_if(finals.begin(), finals.end(), alike);
    if (found == finals.end()) return false;
    finals.erase(found);
    return true;
  }

  /// "Keep the oven closed until a cupcake is on a table, then open it.", "Put every plate on a table, and only then
  /// all the mugs.": what is kept until then is undone at the end.
  bool say_until(const Formula& f, std::vector<Formula>& finals, std::vector<Requirement>& out) {
    const Formula &kept = f.children[0], &last = f.children[1];
    std::vector<Formula> rest = finals;
    const auto undone =
        std::find_if(rest.begin(), rest.end(), [&](const Formula& part) { return opposite(kept, part); });
    const bool opens = undone != rest.end(), denies = kept.op == Op::Forall && kept.children[0].op == Op::Not;
    Formula then = opens ? *undone : kept;
    if (!opens && denies) {
      const Formula inner = kept.children[0].children[0];
      then.children = {inner};
    }
    if ((!opens && !denies) || !take_alike(last, rest) || !take_alike(then, rest)) return false;
    std::vector<Clause> clauses;
    if (opens) clauses.push_back(planned_clause(kept, phrases_));
    clauses.push_back(planned_clause(last, phrases_));
    clauses.push_back(planned_clause(then, phrases_));
    if (phrases_.clear_error()) return false;
    finals = std::move(rest);
    out.push_back({opens ? Requirement::Kind::UntilThen : Requirement::Kind::OnlyThen, std::move(clauses), false, {}});
    return true;
  }

  /// "Open the fridge, take all the eggs out of it and close it again."
  bool reopened(const Formula& open, std::ptrdiff_t undone, std::vector<Formula>& finals,
                std::vector<Requirement>& out) {
    const Formula closed = finals[static_cast<std::size_t>(undone)];
    finals.erase(finals.begin() + undone);
    std::vector<Clause> meanwhile;
    std::vector<Formula> others;
    for (const Formula& part : finals) {
      const bool within = mentions(part, open.terms[0].name);
      if (within) meanwhile.push_back(planned_clause(part, phrases_));
      if (!within) others.push_back(part);
    }
    std::vector<Formula> still;
    for (const Formula& part : others) {  // what you no longer hold
      meanwhile.push_back(planned_clause(part, phrases_));
      const std::size_t before = meanwhile.size();
      join_idioms(meanwhile);
      if (meanwhile.size() < before) continue;
      meanwhile.pop_back();
      still.push_back(part);
    }
    if (meanwhile.empty()) {  // "turn on the oven, cook the egg, and turn the oven off again"
      for (const Formula& part : still) meanwhile.push_back(planned_clause(part, phrases_));
      still.clear();
    }
    meanwhile.insert(meanwhile.begin(), planned_clause(open, phrases_));
    meanwhile.push_back(planned_clause(closed, phrases_));
    if (phrases_.clear_error()) return false;
    finals = std::move(still);
    out.push_back({Requirement::Kind::Again, std::move(meanwhile), false, {}});
    return true;
  }

  /// Two states of which the agent brings one about by hand and so ends the other: open and closed.
  static bool opposite(const Formula& a, const Formula& b) {
    if (a.op != Op::Atom || b.op != Op::Atom || a.terms != b.terms) return false;
    const bool by_hand = direct_action(a.predicate) || direct_action(b.predicate);
    return by_hand && opposite_of(a.predicate) == b.predicate;
  }

  /// "Choose one kitchen.": names an object that later clauses speak of.
  void choose_first() {
    std::vector<std::string> variables;
    for (const auto& [name, domain] : phrases_.scope()) variables.push_back(name);
    if (variables.empty()) return;
    Clause said;
    said.subjects.push_back(phrases_.reference(rng_.pick(variables), Formula{}));
    plan_.message.insert(plan_.message.begin(), {Requirement::Kind::Choose, {said}, false, {}});
  }

  bool choosing_, everyday_;
  Rng rng_;
  std::vector<Formula> conditions_;
  PhrasePlanner phrases_;
  Plan plan_;
};

}  // namespace

Result<Plan> plan_message(const Formula& goal, const std::vector<Formula>& start, PlanOptions options, Rng rng) {
  Planner planner(start, options, rng);
  return options.exactly ? planner.exactly(goal) : planner.plan(goal);
}

}  // namespace unietp
