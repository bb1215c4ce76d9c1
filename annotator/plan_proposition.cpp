#include "annotator/plan_proposition.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "annotator/meaning.h"

namespace unietp {
namespace {

using Op = Formula::Op;

Domain bare(Domain domain) {
  domain.where.clear();
  std::sort(domain.members.begin(), domain.members.end(),
            [](const auto& a, const auto& b) { return std::tie(a.category, a.slice) < std::tie(b.category, b.slice); });
  return domain;
}

/// Whether the parts of a `:where` are independent: no two share a variable that is bound there.
bool is_separable(const Formula& where) {
  if (where.op == Op::And)
    return !where.children.empty() && std::all_of(where.children.begin(), where.children.end(), is_separable);
  if (where.op != Op::Exists) return true;
  return where.children[0].op == Op::Atom && mentions(where.children[0], where.variable);
}

class PropositionPlanner {
 public:
  explicit PropositionPlanner(PhrasePlanner& phrases) : phrases_(phrases) {}

  Proposition of(const Formula& f) {
    switch (f.op) {
      case Op::Atom:
        return atom(f);
      case Op::Equal:
        return operation(f, {named(f.terms[0]), named(f.terms[1])});
      case Op::And:
      case Op::Or:
        if (f.children.size() == 1) return of(f.children[0]);
        return operation(f, {});
      case Op::Not:
        return denied(f);
      case Op::Forall:
        return bound(f, Determiner::Every, 0);
      case Op::Exists:
      case Op::Number:
        return bound(f, Determiner::New, 0);
      case Op::Count:
        return counted(f);
      default:
        return operation(f, {});
    }
  }

 private:
  Proposition operation(const Formula& f, std::vector<NounPhrase> phrases) {
    Proposition said;
    said.op = f.op;
    said.phrases = std::move(phrases);
    said.comparison = f.comparison;
    for (const Formula& child : f.children) said.parts.push_back(of(child));
    return said;
  }

  NounPhrase named(const Term& term) const {
    NounPhrase phrase;
    if (term.kind == Term::Kind::Agent) {
      phrase.determiner = Determiner::Agent;
      return phrase;
    }
    const auto found = phrases_.scope().find(term.name);
    if (found == phrases_.scope().end()) phrases_.fail(exists(term.name, {}, {}));
    if (found != phrases_.scope().end()) phrase.noun = bare(found->second);
    phrase.variable = term.name;
    return phrase;
  }

  Proposition atom(const Formula& f) {
    Proposition said = operation(f, {named(f.terms[0])});
    Complement complement{f.predicate, false, "", {}};
    if (f.terms.size() > 1 && f.terms[1].kind == Term::Kind::Symbol) complement.symbol = f.terms[1].name;
    if (f.terms.size() > 1 && f.terms[1].kind != Term::Kind::Symbol) complement.object = {named(f.terms[1])};
    said.said = {std::move(complement)};
    return said;
  }

  Proposition denied(const Formula& f) {
    Proposition said = of(f.children[0]);
    if (said.op == Op::Atom) {
      said.said[0].negated = !said.said[0].negated;
    } else if (said.op == Op::Equal) {
      said.negated = !said.negated;
    } else {
      Proposition outer;
      outer.op = Op::Not;
      outer.parts = {std::move(said)};
      return outer;
    }
    return said;
  }

  Proposition bound(const Formula& f, Determiner determiner, int number) {
    const PhrasePlanner::Scope outside = phrases_.scope();
    Proposition said;
    said.op = f.op;
    NounPhrase phrase;
    const bool plainly = f.op != Op::Number && described(f, phrase);
    phrases_.scope()[f.variable] = f.domain;
    if (!plainly) {
      phrase = named({Term::Kind::Variable, f.variable});
      for (const Formula& where : f.domain.where) said.where.push_back(of(where));
    }
    phrase.noun = bare(f.domain);
    phrase.variable = f.variable;
    phrase.determiner = determiner;
    phrase.number = number;
    phrase.two = false;
    phrase.there = 0;
    said.phrases = {std::move(phrase)};
    said.parts = {of(f.children[0])};
    phrases_.scope() = outside;
    return said;
  }

  /// Describes it by adjectives and places, if the reader reads them as exactly that.
  bool described(const Formula& f, NounPhrase& phrase) {
    if (phrases_.error()) return false;
    if (!std::all_of(f.domain.where.begin(), f.domain.where.end(), is_separable)) return false;
    phrase = phrases_.quantified(f, Determiner::New);
    if (phrases_.clear_error()) return false;
    return std::all_of(phrase.modifiers.begin(), phrase.modifiers.end(), [](const Complement& modifier) {
      return modifier.object.empty() || modifier.object[0].determiner == Determiner::New ||
             modifier.object[0].determiner == Determiner::Any;
    });
  }

  Proposition counted(const Formula& f) {
    int number = f.number;
    Determiner determiner = PhrasePlanner::counted(f);
    if (f.comparison == Comparison::Greater) determiner = Determiner::AtLeast, ++number;
    if (f.comparison == Comparison::Less) determiner = Determiner::AtMost, --number;
    const bool always = determiner == Determiner::AtLeast && number == 0;
    if (number >= 0 && !always) return bound(f, determiner, number);
    Proposition said;
    said.op = always ? Op::And : Op::Or;
    return said;
  }

  PhrasePlanner& phrases_;
};

/// Whether the formula says that nothing of a domain exists.
bool is_missing(const Formula& f) {
  return f.op == Op::Forall && f.children[0].op == Op::Or && f.children[0].children.empty();
}

bool says_at_end(const Formula& f) {
  return f.op == Op::AtEnd || std::any_of(f.children.begin(), f.children.end(), says_at_end);
}

Formula unsaid(const Formula& f) {
  if (is_missing(f)) return exists(f.variable, f.domain, conjunction({}));
  return f.children[0];
}

}  // namespace

Proposition proposition_of(const Formula& formula, PhrasePlanner& phrases) {
  return PropositionPlanner(phrases).of(formula);
}

Formula gathered(const Formula& formula) {
  const bool tied = std::any_of(formula.children.begin(), formula.children.end(), is_missing);
  if (formula.op != Op::AtEnd && formula.op != Op::Number && !tied && only_at_end(formula) && says_at_end(formula))
    return at_end(gathered(without_at_end(formula)));
  Formula result = formula;
  for (Formula& child : result.children) child = gathered(child);
  const auto negative = std::find_if(result.children.begin(), result.children.end(),
                                     [](const Formula& f) { return f.op == Op::Not || is_missing(f); });
  if (result.op != Op::Or || result.children.size() != 2 || negative == result.children.end()) return result;
  Formula premise = unsaid(*negative);
  result.children.erase(negative);
  result.op = Op::Imply;
  result.children.insert(result.children.begin(), std::move(premise));
  return result;
}

}  // namespace unietp
