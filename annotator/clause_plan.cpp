#include "annotator/clause_plan.h"

#include <algorithm>

namespace unietp {
namespace {

using Op = Formula::Op;
using Scope = PhrasePlanner::Scope;

/// Forall x forall y g: forall y forall x g.
Formula turned(const Formula& f) {
  Formula outer = f.children[0], inner = f;
  inner.children = outer.children;
  outer.children = {std::move(inner)};
  return outer;
}

bool negative(const Formula& f) {
  if (f.op == Op::Not) return true;
  if (f.op == Op::Forall) return negative(f.children[0]);
  return f.op == Op::Or && std::all_of(f.children.begin(), f.children.end(), negative);
}

Formula expanded_negation(const Formula& f) {
  if (f.op == Op::Not) return f.children[0];
  Formula result = f;
  result.op = f.op == Op::Forall ? Op::Exists : Op::And;
  for (Formula& child : result.children) child = expanded_negation(child);
  return result;
}

/// "not (some closed fridge)": the alternative of an `or` that acts as a condition of the rest.
bool excludes(const Formula& f) {
  return f.op == Op::Forall && !f.domain.where.empty() && f.children[0].op == Op::Or && f.children[0].children.empty();
}

/// An object that must exist, without further predicates: "if a fridge is open".
bool only_given(const Formula& binder) {
  const auto free = free_variables(binder.children[0]);
  return !binder.domain.where.empty() && std::find(free.begin(), free.end(), binder.variable) == free.end();
}

const std::string* subject_of(const Formula& f) {
  const Formula& inner = f.op == Op::Not ? f.children[0] : f;
  if (inner.op == Op::Exists && inner.children[0].op == Op::Atom) return subject_of(inner.children[0]);
  if (inner.op != Op::Atom || inner.terms[0].kind != Term::Kind::Variable) return nullptr;
  return &inner.terms[0].name;
}

bool same_saying(const Clause& a, const Clause& b) {
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

class ClausePlanner {
 public:
  explicit ClausePlanner(PhrasePlanner& phrases) : phrases_(phrases) {}

  Clause clause(const Formula& f) {
    Clause said;
    switch (f.op) {
      case Op::And:
        if (f.children.empty()) break;
        said.kind = Clause::Kind::And;
        for (const Formula& part : f.children) said.parts.push_back(clause(part));
        join_subjects(said.parts);
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
        if (!phrases_.complements(f, inner.terms[0].name, said)) phrases_.fail(f);
        return said;
      }
      case Op::CountCompare: {
        said.kind = Clause::Kind::Compare;
        said.comparison = f.comparison;
        for (const Formula& side : f.children) {
          said.subjects.push_back(phrases_.quantified(side, Determiner::New));
          const auto one = phrases_.complement(side.children[0], side.variable, Determiner::Any);
          if (!one) phrases_.fail(side);
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
    phrases_.fail(f);
    return said;
  }

 private:
  /// A clause whose subject is quantified, or whose object is when the bound variable is the second argument.
  Clause quantifier(const Formula& f) {
    Clause said;
    const Formula& body = f.children[0];
    if (f.op == Op::Forall && negative(body)) {
      const Formula positive = expanded_negation(body);
      if (phrases_.complements(positive, f.variable, said)) {
        said.subjects.push_back(phrases_.quantified(f, Determiner::No));
        said.there_now = phrases_.there_now(f, positive);
        return said;
      }
      said = {};
      if (body.op == Op::Forall &&
          phrases_.complements(expanded_negation(turned(f).children[0]), body.variable, said)) {
        said.subjects.push_back(phrases_.quantified(body, Determiner::No));
        said.there_now = phrases_.there_now(body, expanded_negation(turned(f).children[0]));
        return said;
      }
      said = {};
    }
    if (phrases_.complements(body, f.variable, said)) {
      said.subjects.push_back(phrases_.quantified(f, f.op == Op::Exists ? Determiner::Any : phrases_.counted(f)));
      if (f.op == Op::Count) said.there_now = phrases_.there_now(f, body);
      return said;
    }
    const Formula& inner = body.op == Op::Not ? body.children[0] : body;
    said = {};
    if (inner.op == Op::Atom && inner.terms[0].kind == Term::Kind::Variable &&
        phrases_.complements(f, inner.terms[0].name, said)) {
      said.subjects.push_back(phrases_.reference(inner.terms[0].name, f));
      return said;
    }
    phrases_.fail(f);
    return said;
  }

  /// "if a fridge is closed, …"
  Clause conditional(const Formula& f) {
    Formula rest = f;
    std::erase_if(rest.children, excludes);
    if (rest.children.size() != 1) {
      phrases_.fail(f);
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

  PhrasePlanner& phrases_;
};

}  // namespace

Clause planned_clause(const Formula& formula, PhrasePlanner& phrases) { return ClausePlanner(phrases).clause(formula); }

void join_subjects(std::vector<Clause>& clauses) {
  for (std::size_t i = 0; i < clauses.size(); ++i)
    for (std::size_t k = i + 1; k < clauses.size();) {
      const bool plain = !clauses[i].subjects.empty() && clauses[i].kind == Clause::Kind::Simple &&
                         clauses[k].kind == Clause::Kind::Simple && !clauses[i].any_subject &&
                         !clauses[k].any_subject && clauses[k].subjects.size() == 1;
      const auto bare = [](const Clause& c) {
        const Determiner d = c.subjects[0].determiner;
        return d != Determiner::Agent && d != Determiner::No && d != Determiner::Any && d != Determiner::AtMost;
      };
      // "Put the mug that is on the desk and a plate in the sink" reads as if the plate were there, too.
      const auto is_elsewhere = [](const Clause& c) {
        return std::any_of(c.subjects[0].modifiers.begin(), c.subjects[0].modifiers.end(), describes_by_place);
      };
      if (plain && !clauses[i].complements[0].object.empty() &&
          (is_elsewhere(clauses[i]) || is_elsewhere(clauses[k]))) {
        ++k;
        continue;
      }
      if (!plain || !bare(clauses[i]) || !bare(clauses[k]) || !same_saying(clauses[i], clauses[k])) {
        ++k;
        continue;
      }
      clauses[i].subjects.push_back(clauses[k].subjects[0]);
      clauses.erase(clauses.begin() + static_cast<std::ptrdiff_t>(k));
    }
}

}  // namespace unietp
