#include "annotator/phrase_plan.h"

#include <algorithm>

#include "annotator/meaning.h"

namespace unietp {
namespace {

using Op = Formula::Op;

bool is(const Term& term, const std::string& variable) {
  return term.kind == Term::Kind::Variable && term.name == variable;
}

/// Of which objects there are two, whatever the variables are called.
std::string pair_key(const std::string& variable, const Domain& domain, const Formula& body) {
  return to_text(normal_form(exists(variable, domain, body)));
}

}  // namespace

PhrasePlanner::PhrasePlanner(const std::vector<Formula>& start, HomeCounts home) : home_(home) {
  for (const Formula& f : start) {
    if (f.op != Op::Count || f.comparison != Comparison::Equal || f.number != 2) continue;
    pairs_.insert(pair_key(f.variable, f.domain, f.children[0]));
  }
}

void PhrasePlanner::fail(const Formula& part) {
  if (!error_) error_ = Error{Error::Kind::Unsatisfiable, "goal", {}, "the grammar has no words for " + to_text(part)};
}

bool PhrasePlanner::clear_error() {
  const bool failed = error_.has_value();
  error_.reset();
  return failed;
}

NounPhrase PhrasePlanner::reference(const std::string& variable, const Formula& context) {
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

void PhrasePlanner::describe(NounPhrase& phrase, const Domain& domain, const std::string& variable) {
  phrase.noun = domain;
  phrase.noun.where.clear();
  phrase.there = home_.members(domain, variable).size();
  phrase.two = phrase.there == 2;
  if (domain.where.empty()) return;
  const bool size = std::any_of(domain.where.begin(), domain.where.end(), [](const Formula& where) {
    return where.op == Op::Atom && where.predicate == Predicate::Size;
  });
  if (size) phrase.two = home_.members(phrase.noun, variable).size() == 2;
  phrase.two |= pairs_.contains(pair_key(variable, phrase.noun, size ? Formula{} : domain.where[0]));
  for (const Formula& part : scattered(domain.where[0], variable)) {
    auto modifier = complement(part, variable, Determiner::New);
    if (!modifier) modifier = converse(part, variable);
    if (!modifier) fail(part);
    if (modifier) phrase.modifiers.push_back(*modifier);
  }
}

std::vector<Formula> PhrasePlanner::scattered(const Formula& f, const std::string& variable) {
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
std::optional<Complement> PhrasePlanner::converse(const Formula& f, const std::string& variable) {
  if (f.op != Op::Exists || f.children[0].op != Op::Atom || f.children[0].terms.size() != 2) return std::nullopt;
  const Formula& body = f.children[0];
  const bool held = body.predicate == Predicate::Inside || body.predicate == Predicate::On;
  if (!held || !is(body.terms[0], f.variable) || !is(body.terms[1], variable)) return std::nullopt;
  return Complement{body.predicate, false, "", {quantified(f, Determiner::New)}, true};
}

NounPhrase PhrasePlanner::quantified(const Formula& binder, Determiner determiner) {
  NounPhrase phrase;
  describe(phrase, binder.domain, binder.variable);
  phrase.determiner = determiner;
  phrase.number = binder.number;
  return phrase;
}

std::size_t PhrasePlanner::there_now(const Formula& binder, Formula said) const {
  for (const std::string& free : free_variables(said)) {
    if (free == binder.variable) continue;
    const auto found = scope_.find(free);
    if (found == scope_.end()) return 0;
    said = exists(free, found->second, std::move(said));
  }
  Domain so = binder.domain;
  std::vector<Formula> all = so.where;
  all.push_back(std::move(said));
  so.where = {conjunction(std::move(all))};
  return home_.members(so, binder.variable).size();
}

std::optional<Complement> PhrasePlanner::complement(const Formula& f, const std::string& variable, Determiner local) {
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

Determiner PhrasePlanner::counted(const Formula& f) {
  if (f.op == Op::Forall) return Determiner::Every;
  if (f.comparison == Comparison::Equal) return Determiner::Exactly;
  return f.comparison == Comparison::AtLeast ? Determiner::AtLeast : Determiner::AtMost;
}

bool PhrasePlanner::complements(const Formula& f, const std::string& variable, Clause& into) {
  into.any_complement = f.op == Op::Or;
  const bool list = f.op == Op::Or || f.op == Op::And;
  if (list && f.children.empty()) return false;
  for (const Formula& part : list ? f.children : std::vector<Formula>{f}) {
    auto said = complement(part, variable, Determiner::Any);
    if (!said) return false;
    into.complements.push_back(std::move(*said));
  }
  return true;
}

}  // namespace unietp
