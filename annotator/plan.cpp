#include "annotator/plan.h"

#include <algorithm>
#include <optional>

#include "annotator/clause_plan.h"
#include "annotator/conditions.h"
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
      : choosing_(options.choosing), everyday_(options.everyday), rng_(rng), phrases_(start) {
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
    if (everyday_ || rng_.chance(0.8)) join_subjects(clauses);
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
        return say(Kind::Until, {said(0), said(1)});
      case Op::Sometime: {
        const auto undone = std::find_if(finals.begin(), finals.end(),
                                         [&](const Formula& part) { return opposite(f.children[0], part); });
        const auto meanwhile = [&](const Formula& part) {
          return !(part == *undone) && mentions(part, f.children[0].terms[0].name);
        };
        if (undone == finals.end() || (!everyday_ && rng_.chance(0.3)) ||
            std::any_of(finals.begin(), finals.end(), meanwhile)) {
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
        if (!ends || (apart && !(kept && everyday_))) return say(Kind::Before, std::move(clauses));
        finals = std::move(rest);
        return say(kept ? Kind::ThenKept : Kind::Then, std::move(clauses));
      }
      default:
        return false;
    }
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
