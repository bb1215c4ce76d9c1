#include "annotator/plan.h"

#include <algorithm>
#include <optional>

#include "annotator/conditions.h"
#include "annotator/meaning.h"
#include "annotator/phrase_plan.h"
#include "annotator/plan_proposition.h"

namespace unietp {
namespace {

using Op = Formula::Op;
using Scope = PhrasePlanner::Scope;

class Planner {
 public:
  Planner(const std::vector<Formula>& start, PlanOptions options, Rng rng)
      : choosing_(options.choosing), rng_(rng), phrases_(start) {
    if (options.conditions) conditions_ = conditions_of(start);
  }

  /// All of it as one proposition.
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
    std::vector<Formula> stated;  // what no clause says
    for (const Formula& part : others)
      if (!add_temporal(part, finals, part.op == Op::Always ? late : early)) stated.push_back(part);
    std::vector<Clause> clauses;
    for (const Formula& part : finals) {
      Clause said = clause(part);
      if (phrases_.forgive()) {
        stated.push_back(at_end(part));
      } else {
        clauses.push_back(std::move(said));
      }
    }
    if (rng_.chance(0.8)) group(clauses);
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

  /// Where it is said plainly: of something that is so, not of what it is not.
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

  /// Says it with what belongs to it of `finals`. False, and nothing is changed, when no clause can.
  bool add_temporal(const Formula& f, std::vector<Formula>& finals, std::vector<Requirement>& out) {
    using Kind = Requirement::Kind;
    const auto say = [&](Kind kind, std::vector<Clause> clauses) {
      if (phrases_.forgive()) return false;
      out.push_back({kind, std::move(clauses), false, {}});
      return true;
    };
    const auto said = [&](std::size_t i) { return clause(f.children[i]); };
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
        if (undone == finals.end() || rng_.chance(0.3) || std::any_of(finals.begin(), finals.end(), meanwhile)) {
          // What is taken out of an open fridge is said before the fridge is closed.
          if (undone != finals.end()) std::rotate(undone, undone + 1, finals.end());
          return say(Kind::Sometime, {said(0)});
        }
        const bool found = say(Kind::Again, {said(0), clause(*undone)});
        if (found) finals.erase(undone);
        return found;
      }
      case Op::Before: {
        const bool apart = rng_.chance(0.25);
        std::vector<Clause> clauses{said(0), said(1)};
        if (phrases_.forgive()) return false;
        if (apart || !take(f.children[1], finals)) return say(Kind::Before, std::move(clauses));
        return say(take(f.children[0], finals) ? Kind::ThenKept : Kind::Then, std::move(clauses));
      }
      default:
        return false;
    }
  }

  static bool opposite(const Formula& a, const Formula& b) {
    if (a.op != Op::Atom || b.op != Op::Atom || a.terms != b.terms) return false;
    using P = Predicate;
    for (const auto& [p, q] : {std::pair{P::Open, P::Closed},
                               {P::PowerOn, P::PowerOff},
                               {P::PluggedIn, P::Unplugged},
                               {P::Folded, P::Unfolded}})
      if ((a.predicate == p && b.predicate == q) || (a.predicate == q && b.predicate == p)) return true;
    return false;
  }

  Clause clause(const Formula& f) {
    Clause said;
    switch (f.op) {
      case Op::And:
        if (f.children.empty()) break;
        said.kind = Clause::Kind::And;
        for (const Formula& part : f.children) said.parts.push_back(clause(part));
        group(said.parts);
        return said;
      case Op::Or:
        if (f.children.empty()) break;
        return alternatives(f);
      case Op::Atom:
      case Op::Not: {
        const Formula& inner = f.op == Op::Not ? f.children[0] : f;
        if (inner.op != Op::Atom) break;
        if (inner.terms[0].kind == Term::Kind::Agent) {
          NounPhrase you;
          you.determiner = Determiner::Agent;
          said.subjects.push_back(you);
          said.complements.push_back(
              {inner.predicate, f.op == Op::Not, "", {phrases_.reference(inner.terms[1].name, f)}});
          return said;
        }
        said.subjects.push_back(phrases_.reference(inner.terms[0].name, f));
        if (!phrases_.complements(f, inner.terms[0].name, said)) fail(f);
        return said;
      }
      case Op::CountCompare: {
        said.kind = Clause::Kind::Compare;
        said.comparison = f.comparison;
        for (const Formula& side : f.children) {
          said.subjects.push_back(phrases_.quantified(side, Determiner::New));
          const auto one = phrases_.complement(side.children[0], side.variable, Determiner::Any);
          if (!one) fail(side);
          if (one) said.complements.push_back(*one);
        }
        return said;
      }
      case Op::Forall:
      case Op::Exists:
      case Op::Count:
        return quantifier(f);
      default:
        break;
    }
    fail(f);
    return said;
  }

  /// A clause whose subject is quantified, or, when the bound variable stands second, whose object is.
  Clause quantifier(const Formula& f) {
    Clause said;
    const Formula& body = f.children[0];
    if (f.op == Op::Forall && negative(body)) {
      const Formula positive = expanded_negation(body);
      if (phrases_.complements(positive, f.variable, said)) {
        said.subjects.push_back(phrases_.quantified(f, Determiner::No));
        return said;
      }
      said = {};
      if (body.op == Op::Forall &&
          phrases_.complements(expanded_negation(turned(f).children[0]), body.variable, said)) {
        said.subjects.push_back(phrases_.quantified(body, Determiner::No));
        return said;
      }
      said = {};
    }
    if (phrases_.complements(body, f.variable, said)) {
      said.subjects.push_back(phrases_.quantified(f, f.op == Op::Exists ? Determiner::Any : phrases_.counted(f)));
      return said;
    }
    const Formula& inner = body.op == Op::Not ? body.children[0] : body;
    said = {};
    if (inner.op == Op::Atom && inner.terms[0].kind == Term::Kind::Variable &&
        phrases_.complements(f, inner.terms[0].name, said)) {
      said.subjects.push_back(phrases_.reference(inner.terms[0].name, f));
      return said;
    }
    fail(f);
    return said;
  }

  /// Forall x forall y g: forall y forall x g.
  static Formula turned(const Formula& f) {
    Formula outer = f.children[0], inner = f;
    inner.children = outer.children;
    outer.children = {std::move(inner)};
    return outer;
  }

  static bool negative(const Formula& f) {
    if (f.op == Op::Not) return true;
    if (f.op == Op::Forall) return negative(f.children[0]);
    return f.op == Op::Or && std::all_of(f.children.begin(), f.children.end(), negative);
  }

  static Formula expanded_negation(const Formula& f) {
    if (f.op == Op::Not) return f.children[0];
    Formula result = f;
    result.op = f.op == Op::Forall ? Op::Exists : Op::And;
    for (Formula& child : result.children) child = expanded_negation(child);
    return result;
  }

  /// "not (some closed fridge)": of an `or`, what the rest is tied to.
  static bool excludes(const Formula& f) {
    return f.op == Op::Forall && !f.domain.where.empty() && f.children[0].op == Op::Or &&
           f.children[0].children.empty();
  }

  /// "if a fridge is closed, …"
  Clause conditional(const Formula& f) {
    Formula rest = f;
    std::erase_if(rest.children, excludes);
    if (rest.children.size() != 1) {
      fail(f);
      return {};
    }
    const Scope outer = phrases_.scope();
    const Formula* body = &rest.children[0];
    for (; body->op == Op::Exists; body = &body->children[0]) phrases_.scope()[body->variable] = body->domain;
    Clause said = clause(*body);
    for (const Formula& part : f.children)
      if (excludes(part)) said.given.push_back(phrases_.quantified(part, Determiner::New));
    phrases_.scope() = outer;
    return said;
  }

  Clause alternatives(const Formula& f) {
    Clause said;
    if (std::any_of(f.children.begin(), f.children.end(), excludes)) return conditional(f);
    if (const auto* first = subject_of(f.children[0]); first != nullptr) {
      bool shared = true;
      for (const Formula& part : f.children) shared = shared && subject_of(part) && *subject_of(part) == *first;
      const std::string variable = *first;
      if (shared && phrases_.scope().contains(variable) && phrases_.complements(f, variable, said)) {
        said.subjects.push_back(phrases_.reference(variable, f));
        return said;
      }
    }
    said = {};
    Scope outer = phrases_.scope();
    bool same = true;
    for (const Formula& part : f.children) {  // objects of an alternative are New in it
      const Formula* body = &part;
      std::vector<NounPhrase> given;
      for (; body->op == Op::Exists; body = &body->children[0]) {
        phrases_.scope()[body->variable] = body->domain;
        if (only_given(*body)) given.push_back(phrases_.reference(body->variable, *body));
      }
      said.parts.push_back(clause(*body));
      same = same && given.empty();
      said.parts.back().given = std::move(given);
    }
    phrases_.scope() = outer;
    for (const Clause& part : said.parts)
      same = same && part.kind == Clause::Kind::Simple && part.subjects.size() == 1 && same_saying(part, said.parts[0]);
    for (const Clause& part : said.parts)
      for (const Complement& complement : part.complements)
        for (const NounPhrase& object : complement.object)
          same = same && (object.variable.empty() || phrases_.scope().contains(object.variable));
    if (!same) {
      said.kind = Clause::Kind::Or;
      return said;
    }
    Clause merged = said.parts[0];
    for (std::size_t i = 1; i < said.parts.size(); ++i) merged.subjects.push_back(said.parts[i].subjects[0]);
    merged.any_subject = true;
    return merged;
  }

  /// Something that has to be there, and of which nothing else is said: "if a fridge is open".
  static bool only_given(const Formula& binder) {
    const auto free = free_variables(binder.children[0]);
    return !binder.domain.where.empty() && std::find(free.begin(), free.end(), binder.variable) == free.end();
  }

  static const std::string* subject_of(const Formula& f) {
    const Formula& inner = f.op == Op::Not ? f.children[0] : f;
    if (inner.op == Op::Exists && inner.children[0].op == Op::Atom) return subject_of(inner.children[0]);
    if (inner.op != Op::Atom || inner.terms[0].kind != Term::Kind::Variable) return nullptr;
    return &inner.terms[0].name;
  }

  static bool same_saying(const Clause& a, const Clause& b) {
    if (a.complements.size() != b.complements.size() || a.any_complement != b.any_complement) return false;
    for (std::size_t i = 0; i < a.complements.size(); ++i) {
      const Complement &x = a.complements[i], &y = b.complements[i];
      if (x.predicate != y.predicate || x.negated != y.negated || x.symbol != y.symbol) return false;
      if (x.object.size() != y.object.size()) return false;
      if (!x.object.empty() && (x.object[0].variable.empty() || x.object[0].variable != y.object[0].variable))
        return false;
    }
    return true;
  }

  /// Joins clauses that say the same of several subjects: "put a mug and a bowl on a table".
  static void group(std::vector<Clause>& clauses) {
    for (std::size_t i = 0; i < clauses.size(); ++i)
      for (std::size_t k = i + 1; k < clauses.size();) {
        const bool plain = !clauses[i].subjects.empty() && clauses[i].kind == Clause::Kind::Simple &&
                           clauses[k].kind == Clause::Kind::Simple && !clauses[i].any_subject &&
                           !clauses[k].any_subject && clauses[k].subjects.size() == 1;
        const auto bare = [](const Clause& c) {
          const Determiner d = c.subjects[0].determiner;
          return d != Determiner::Agent && d != Determiner::No && d != Determiner::Any;
        };
        if (!plain || !bare(clauses[i]) || !bare(clauses[k]) || !same_saying(clauses[i], clauses[k])) {
          ++k;
          continue;
        }
        clauses[i].subjects.push_back(clauses[k].subjects[0]);
        clauses.erase(clauses.begin() + static_cast<std::ptrdiff_t>(k));
      }
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

  bool choosing_;
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
