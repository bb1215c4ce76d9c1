#include "annotator/compose_proposition.h"

#include <utility>

namespace unietp {
namespace {

using Op = Formula::Op;

Term referred(const NounPhrase& phrase, References& references) {
  switch (phrase.determiner) {
    case Determiner::Agent:
      return {Term::Kind::Agent, "agent"};
    case Determiner::The:
    case Determiner::Known:
    case Determiner::It:
    case Determiner::Ordinal:
      if (phrase.modifiers.empty() && phrase.done.empty()) return references.known(phrase);
      [[fallthrough]];
    default:
      references.fail(phrase.column, "expected something named before; 'for some …, …' names it");
      return {};
  }
}

Formula atom(const Proposition& said, References& references) {
  const Term subject = referred(said.phrases[0], references);
  const Complement& complement = said.said[0];
  if (complement.object.empty()) return said_of(complement, subject, nullptr);
  Resolved object;
  object.term = referred(complement.object[0], references);
  return said_of(complement, subject, &object);
}

Formula same(const Proposition& said, References& references) {
  Formula f;
  f.op = Op::Equal;
  for (const NounPhrase& phrase : said.phrases) f.terms.push_back(referred(phrase, references));
  return said.negated ? negation(std::move(f)) : f;
}

Formula bound(const Proposition& said, References& references) {
  const std::size_t outside = references.named_count();
  Resolved slot = references.bound(said.phrases[0]);
  for (const Proposition& where : said.where) {
    std::vector<Formula> all = std::move(slot.domain.where);
    all.push_back(compose_proposition(where, references));
    slot.domain.where = {conjunction(std::move(all))};
  }
  Formula f = quantified(slot, compose_proposition(said.parts[0], references));
  if (said.op == Op::Number) f.op = Op::Number;
  references.leave(outside);
  return f;
}

}  // namespace

Formula compose_proposition(const Proposition& said, References& references) {
  if (references.error()) return {};
  switch (said.op) {
    case Op::Atom:
      return atom(said, references);
    case Op::Equal:
      return same(said, references);
    case Op::Forall:
    case Op::Exists:
    case Op::Count:
    case Op::Number:
      return bound(said, references);
    default:
      break;
  }
  Formula f;
  f.op = said.op;
  f.comparison = said.comparison;
  for (const Proposition& part : said.parts) f.children.push_back(compose_proposition(part, references));
  return f;
}

}  // namespace unietp
