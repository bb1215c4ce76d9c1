#include "annotator/plan.h"

#include <algorithm>
#include <map>
#include <optional>

#include "annotator/conditions.h"
#include "annotator/meaning.h"

namespace unietp {
namespace {

using Op = Formula::Op;
using Scope = std::map<std::string, Domain>;

class Planner {
 public:
  Planner(const std::vector<Formula>& start, PlanOptions options, Rng rng) : choosing_(options.choosing), rng_(rng) {
    if (options.conditions) conditions_ = conditions_of(start);
    for (const Formula& f : start) {
      if (f.op != Op::Count || f.comparison != Comparison::Equal || f.number != 2) continue;
      pairs_.insert(pair_key(f.variable, f.domain, f.children[0]));
    }
  }

  Result<Plan> plan(const Formula& goal) {
    Formula body = goal;
    while (body.op == Op::Exists) {
      scope_[body.variable] = body.domain;
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
    for (const Formula& part : others) add_temporal(part, finals, part.op == Op::Always ? late : early);
    std::vector<Clause> clauses;
    for (const Formula& part : finals) clauses.push_back(clause(part));
    if (error_) return *error_;
    if (rng_.chance(0.8)) group(clauses);
    plan_.message = std::move(early);
    for (Clause& said : clauses) plan_.message.push_back({Requirement::Kind::Final, {std::move(said)}});
    for (Requirement& requirement : late) plan_.message.push_back(std::move(requirement));
    if (choosing_ && rng_.chance(0.5)) choose_first();
    for (const Formula& f : conditions_) add_condition(f);
    rng_.shuffle(plan_.conditions);
    return plan_;
  }

 private:
  void fail(const Formula& part) {
    if (!error_)
      error_ = Error{Error::Kind::Unsatisfiable, "goal", {}, "the grammar has no words for " + to_text(part)};
  }

  /// Where it is said plainly: of something that is so, not of what it is not.
  void add_condition(const Formula& condition) {
    NounPhrase phrase;
    phrase.noun = condition.domain;
    phrase.noun.where.clear();
    const Formula where = expanded(condition.domain.where[0]);
    for (const Formula& part : scattered(where, condition.variable)) {
      if (part.op != Op::Atom && part.op != Op::Exists) return;
      const auto said = complement(part, condition.variable, Determiner::New);
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

  void add_temporal(const Formula& f, std::vector<Formula>& finals, std::vector<Requirement>& out) {
    using Kind = Requirement::Kind;
    const auto said = [&](std::size_t i) { return clause(f.children[i]); };
    switch (f.op) {
      case Op::Always:
        out.push_back({Kind::Always, {said(0)}});
        return;
      case Op::Until:
        out.push_back({Kind::Until, {said(0), said(1)}});
        return;
      case Op::Sometime: {
        const Formula* undone = nullptr;
        for (const Formula& part : finals)
          if (opposite(f.children[0], part)) undone = &part;
        if (undone == nullptr || rng_.chance(0.3)) {
          out.push_back({Kind::Sometime, {said(0)}});
          return;
        }
        out.push_back({Kind::Again, {said(0), clause(*undone)}});
        finals.erase(finals.begin() + (undone - finals.data()));
        return;
      }
      case Op::Before: {
        if (rng_.chance(0.25) || !take(f.children[1], finals)) {
          out.push_back({Kind::Before, {said(0), said(1)}});
        } else {
          const bool kept = take(f.children[0], finals);
          out.push_back({kept ? Kind::ThenKept : Kind::Then, {said(0), said(1)}});
        }
        return;
      }
      default:
        fail(f);
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

  NounPhrase reference(const std::string& variable, const Formula& context) {
    NounPhrase phrase;
    const auto found = scope_.find(variable);
    if (found == scope_.end()) {
      fail(context);
      return phrase;
    }
    phrase.variable = variable;
    describe(phrase, found->second, variable);
    return phrase;
  }

  void describe(NounPhrase& phrase, const Domain& domain, const std::string& variable) {
    phrase.noun = domain;
    phrase.noun.where.clear();
    if (domain.where.empty()) return;
    const bool size = std::any_of(domain.where.begin(), domain.where.end(), [](const Formula& where) {
      return where.op == Op::Atom && where.predicate == Predicate::Size;
    });
    phrase.two = pairs_.contains(pair_key(variable, phrase.noun, size ? Formula{} : domain.where[0]));
    for (const Formula& part : scattered(domain.where[0], variable)) {
      auto modifier = complement(part, variable, Determiner::New);
      if (!modifier) modifier = converse(part, variable);
      if (!modifier) fail(part);
      if (modifier) phrase.modifiers.push_back(*modifier);
    }
  }

  /// What is said of the variable, one by one: `expanded` has pulled the quantifiers to the front.
  static std::vector<Formula> scattered(const Formula& f, const std::string& variable) {
    if (f.op != Op::And && f.op != Op::Exists) return {f};
    std::vector<Formula> parts;
    for (const Formula& child : f.children) {
      for (Formula& part : scattered(child, variable)) {
        const bool bound = f.op == Op::Exists && mentions(part, f.variable);
        parts.push_back(bound ? exists(f.variable, f.domain, std::move(part)) : std::move(part));
      }
    }
    return parts;
  }

  /// "where a plate is kept": what is said of the variable by something else.
  std::optional<Complement> converse(const Formula& f, const std::string& variable) {
    if (f.op != Op::Exists || f.children[0].op != Op::Atom || f.children[0].terms.size() != 2) return std::nullopt;
    const Formula& body = f.children[0];
    const bool held = body.predicate == Predicate::Inside || body.predicate == Predicate::On;
    if (!held || !is(body.terms[0], f.variable) || !is(body.terms[1], variable)) return std::nullopt;
    return Complement{body.predicate, false, "", {quantified(f, Determiner::New)}, true};
  }

  NounPhrase quantified(const Formula& binder, Determiner determiner) {
    NounPhrase phrase;
    describe(phrase, binder.domain, binder.variable);
    phrase.determiner = determiner;
    phrase.number = binder.number;
    return phrase;
  }

  static bool is(const Term& term, const std::string& variable) {
    return term.kind == Term::Kind::Variable && term.name == variable;
  }

  /// What `f` says of the variable, when that is one state or relation. `local`: how an object bound inside is named.
  std::optional<Complement> complement(const Formula& f, const std::string& variable, Determiner local) {
    if (f.op == Op::Not) {
      auto inner = complement(f.children[0], variable, local);
      if (inner) inner->negated = !inner->negated;
      return inner;
    }
    if (f.op == Op::Atom && is(f.terms[0], variable)) {
      Complement said{f.predicate, false, "", {}};
      if (f.terms.size() == 1) return said;
      if (is(f.terms[1], variable)) return std::nullopt;
      if (f.terms[1].kind == Term::Kind::Symbol) said.symbol = f.terms[1].name;
      if (f.terms[1].kind == Term::Kind::Variable) said.object.push_back(reference(f.terms[1].name, f));
      return said;
    }
    const bool none = f.op == Op::Forall && f.children[0].op == Op::Not;  // not on any table
    if (f.op != Op::Exists && f.op != Op::Count && f.op != Op::Forall) return std::nullopt;
    const Formula& body = none ? f.children[0].children[0] : f.children[0];
    if (body.op != Op::Atom || body.terms.size() != 2 || !is(body.terms[0], variable) || !is(body.terms[1], f.variable))
      return std::nullopt;
    const Determiner determiner = f.op == Op::Exists ? local : none ? Determiner::Any : counted(f);
    return Complement{body.predicate, none, "", {quantified(f, determiner)}};
  }

  static Determiner counted(const Formula& f) {
    if (f.op == Op::Forall) return Determiner::Every;
    if (f.comparison == Comparison::Equal) return Determiner::Exactly;
    return f.comparison == Comparison::AtLeast ? Determiner::AtLeast : Determiner::AtMost;
  }

  /// All that `f` says of the variable, joined by and or by or.
  bool complements(const Formula& f, const std::string& variable, Clause& into) {
    into.any_complement = f.op == Op::Or;
    const bool list = f.op == Op::Or || f.op == Op::And;
    for (const Formula& part : list ? f.children : std::vector<Formula>{f}) {
      auto said = complement(part, variable, Determiner::Any);
      if (!said) return false;
      into.complements.push_back(std::move(*said));
    }
    return true;
  }

  Clause clause(const Formula& f) {
    Clause said;
    switch (f.op) {
      case Op::And:
        said.kind = Clause::Kind::And;
        for (const Formula& part : f.children) said.parts.push_back(clause(part));
        group(said.parts);
        return said;
      case Op::Or:
        return alternatives(f);
      case Op::Atom:
      case Op::Not: {
        const Formula& inner = f.op == Op::Not ? f.children[0] : f;
        if (inner.op != Op::Atom) break;
        if (inner.terms[0].kind == Term::Kind::Agent) {
          NounPhrase you;
          you.determiner = Determiner::Agent;
          said.subjects.push_back(you);
          said.complements.push_back({inner.predicate, f.op == Op::Not, "", {reference(inner.terms[1].name, f)}});
          return said;
        }
        said.subjects.push_back(reference(inner.terms[0].name, f));
        if (!complements(f, inner.terms[0].name, said)) fail(f);
        return said;
      }
      case Op::CountCompare: {
        said.kind = Clause::Kind::Compare;
        said.comparison = f.comparison;
        for (const Formula& side : f.children) {
          said.subjects.push_back(quantified(side, Determiner::New));
          const auto one = complement(side.children[0], side.variable, Determiner::Any);
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
      if (complements(positive, f.variable, said)) {
        said.subjects.push_back(quantified(f, Determiner::No));
        return said;
      }
      said = {};
      if (body.op == Op::Forall && complements(expanded_negation(turned(f).children[0]), body.variable, said)) {
        said.subjects.push_back(quantified(body, Determiner::No));
        return said;
      }
      said = {};
    }
    if (complements(body, f.variable, said)) {
      said.subjects.push_back(quantified(f, f.op == Op::Exists ? Determiner::Any : counted(f)));
      return said;
    }
    const Formula& inner = body.op == Op::Not ? body.children[0] : body;
    said = {};
    if (inner.op == Op::Atom && inner.terms[0].kind == Term::Kind::Variable &&
        complements(f, inner.terms[0].name, said)) {
      said.subjects.push_back(reference(inner.terms[0].name, f));
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
    const Scope outer = scope_;
    const Formula* body = &rest.children[0];
    for (; body->op == Op::Exists; body = &body->children[0]) scope_[body->variable] = body->domain;
    Clause said = clause(*body);
    for (const Formula& part : f.children)
      if (excludes(part)) said.given.push_back(quantified(part, Determiner::New));
    scope_ = outer;
    return said;
  }

  Clause alternatives(const Formula& f) {
    Clause said;
    if (std::any_of(f.children.begin(), f.children.end(), excludes)) return conditional(f);
    if (const auto* first = subject_of(f.children[0]); first != nullptr) {
      bool shared = true;
      for (const Formula& part : f.children) shared = shared && subject_of(part) && *subject_of(part) == *first;
      const std::string variable = *first;
      if (shared && scope_.contains(variable) && complements(f, variable, said)) {
        said.subjects.push_back(reference(variable, f));
        return said;
      }
    }
    said = {};
    Scope outer = scope_;
    bool same = true;
    for (const Formula& part : f.children) {  // objects of an alternative are New in it
      const Formula* body = &part;
      std::vector<NounPhrase> given;
      for (; body->op == Op::Exists; body = &body->children[0]) {
        scope_[body->variable] = body->domain;
        if (only_given(*body)) given.push_back(reference(body->variable, *body));
      }
      said.parts.push_back(clause(*body));
      same = same && given.empty();
      said.parts.back().given = std::move(given);
    }
    scope_ = outer;
    for (const Clause& part : said.parts)
      same = same && part.kind == Clause::Kind::Simple && part.subjects.size() == 1 && same_saying(part, said.parts[0]);
    for (const Clause& part : said.parts)
      for (const Complement& complement : part.complements)
        for (const NounPhrase& object : complement.object)
          same = same && (object.variable.empty() || scope_.contains(object.variable));
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
        const bool plain = clauses[i].kind == Clause::Kind::Simple && clauses[k].kind == Clause::Kind::Simple &&
                           !clauses[i].any_subject && !clauses[k].any_subject && clauses[k].subjects.size() == 1;
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
    for (const auto& [name, domain] : scope_) variables.push_back(name);
    if (variables.empty()) return;
    Clause said;
    said.subjects.push_back(reference(rng_.pick(variables), Formula{}));
    plan_.message.insert(plan_.message.begin(), {Requirement::Kind::Choose, {said}});
  }

  /// Of which objects there are two, whatever the variables are called.
  static std::string pair_key(const std::string& variable, const Domain& domain, const Formula& body) {
    return to_text(normal_form(exists(variable, domain, body)));
  }

  bool choosing_;
  Rng rng_;
  std::vector<Formula> conditions_;
  std::set<std::string> pairs_;  // pair_key of what the start has exactly two of
  Scope scope_;
  Plan plan_;
  std::optional<Error> error_;
};

}  // namespace

Result<Plan> plan_message(const Formula& goal, const std::vector<Formula>& start, PlanOptions options, Rng rng) {
  return Planner(start, options, rng).plan(goal);
}

}  // namespace unietp
