#include "annotator/references.h"

#include <algorithm>

namespace unietp {
namespace {

using Op = Formula::Op;

std::string numbered(int number) { return std::string("n").append(std::to_string(number)); }
Term reference_variable(const std::string& name) { return {Term::Kind::Variable, name}; }

/// "The fridge" promises that there is one, so that a later "the fridge" is the same; "the mug on a desk" does not.
bool is_definite(const NounPhrase& phrase) { return phrase.determiner == Determiner::The && phrase.modifiers.empty(); }

}  // namespace

Formula boxed(const Box& box, Formula body) {
  std::vector<Formula> parts = box.distinct;
  parts.push_back(std::move(body));
  Formula f = conjunction(std::move(parts));
  for (auto i = box.variables.rbegin(); i != box.variables.rend(); ++i) f = exists(i->first, i->second, std::move(f));
  return f;
}

void References::fail(int column, std::string message) {
  if (!error_) error_ = Error{Error::Kind::Parse, "instruction", {1, column}, std::move(message)};
}

std::string References::fresh() { return numbered(++count_); }

std::vector<const References::Referent*> References::named(const Domain& noun) const {
  std::vector<const Referent*> found;
  for (const Referent& referent : referents_)
    if (referent.noun == noun || (noun.kind == Domain::Kind::Object && referent.vague)) found.push_back(&referent);
  return found;
}

bool References::hidden(const Domain& noun) const {
  return std::find(hidden_.begin(), hidden_.end(), noun) != hidden_.end();
}

Domain References::restricted(const NounPhrase& phrase, const std::string& name, Box* text) {
  Domain domain = phrase.noun;
  absent_.insert(absent_.end(), phrase.absent.begin(), phrase.absent.end());
  std::vector<Formula> where;
  for (const Complement& modifier : phrase.modifiers)
    where.push_back(restriction(modifier, reference_variable(name), text));
  if (where.empty()) return domain;
  Formula test = conjunction(std::move(where));
  domain.where.push_back(phrase.except ? negation(std::move(test)) : std::move(test));
  return domain;
}

/// "that is on a desk": the desk is any desk, and is not a referent of the text; "the desk" may be.
Formula References::restriction(const Complement& modifier, const Term& subject, Box* text) {
  if (modifier.object.empty()) return said_of(modifier, subject, nullptr);
  const NounPhrase& phrase = modifier.object[0];
  Resolved slot;
  slot.phrase = &phrase;
  switch (phrase.determiner) {
    case Determiner::Known:
    case Determiner::It:
    case Determiner::Ordinal:
      slot.term = known(phrase);
      break;
    case Determiner::The:
      if (is_definite(phrase) && !named(phrase.noun).empty()) {
        slot.term = known(phrase);
        break;
      }
      if (text != nullptr && modifier.predicate == Predicate::InRoom) {
        slot.term = introduced(phrase, *text).term;
        break;
      }
      [[fallthrough]];
    case Determiner::New:
    case Determiner::Single:
    case Determiner::Any: {
      const std::string name = fresh();
      if (!is_definite(phrase)) hidden_.push_back(phrase.noun);
      slot = {reference_variable(name), true, restricted(phrase, name), &phrase};
      break;
    }
    default:
      fail(phrase.column, "a description may only name one other object");
  }
  return said_of(modifier, subject, &slot);
}

/// What was named last, or, less likely, something that was named before.
Term References::pronoun(int column) {
  if (referents_.empty()) {
    fail(column, "'it' means something that was named before, and nothing was");
    return {};
  }
  std::vector<std::string> latest;
  for (const Referent& referent : referents_) latest.push_back(referent.variable);
  const std::string last = clause_ == 0 ? "" : mentions_[clause_ - 1];
  const auto found = std::find(latest.begin(), latest.end(), last);
  if (found != latest.end()) std::rotate(found, found + 1, latest.end());
  const std::size_t back = choices_.choose(latest.size());
  const std::string& meant = latest[latest.size() - 1 - back];
  strained_ = strained_ || (meant != last && (meant != topic_ || last.empty()));
  mentions_.push_back(meant);
  return reference_variable(meant);
}

Term References::known(const NounPhrase& phrase) {
  if (phrase.determiner == Determiner::It) return pronoun(phrase.column);
  const std::vector<const Referent*> found = named(phrase.noun);
  const auto meant = [&](const Referent& one) {
    mentions_.push_back(one.variable);
    return reference_variable(one.variable);
  };
  if (phrase.determiner == Determiner::Ordinal) {
    if (phrase.number <= static_cast<int>(found.size())) return meant(*found[phrase.number - 1]);
    fail(phrase.column, "fewer objects of this kind were named before");
    return {};
  }
  if (found.size() == 1) return meant(*found[0]);
  fail(phrase.column, found.empty() ? "no such object was named before" : "several such objects were named before");
  return {};
}

Resolved References::resolve(const NounPhrase& phrase, Box& box) {
  Resolved slot;
  slot.phrase = &phrase;
  switch (phrase.determiner) {
    case Determiner::Agent:
      slot.term = {Term::Kind::Agent, "agent"};
      return slot;
    case Determiner::Known:
    case Determiner::It:
    case Determiner::Ordinal:
      slot.term = known(phrase);
      return slot;
    case Determiner::The:
      if (phrase.modifiers.empty() && !named(phrase.noun).empty()) {
        slot.term = known(phrase);
        return slot;
      }
      if (hidden(phrase.noun)) fail(phrase.column, "which one is meant is not clear; say 'a …' for a new one");
      return introduced(phrase, box);
    case Determiner::New:
    case Determiner::Single:
      return introduced(phrase, box);
    case Determiner::Another: {
      const std::vector<const Referent*> others = named(phrase.noun);
      if (others.empty()) fail(phrase.column, "'another' needs one of the kind named before");
      const std::string next = numbered(count_ + 1);
      for (const Referent* other : others) {
        Formula same;
        same.op = Op::Equal;
        same.terms = {reference_variable(next), reference_variable(other->variable)};
        box.distinct.push_back(negation(same));
      }
      return introduced(phrase, box);
    }
    default:
      break;
  }
  return any_of(phrase, box);
}

Resolved References::any_of(const NounPhrase& phrase, Box& box) {
  const std::string name = fresh();
  hidden_.push_back(phrase.noun);
  const bool all = phrase.determiner == Determiner::Every || phrase.determiner == Determiner::No;
  Resolved slot{reference_variable(name), true, restricted(phrase, name, all ? &box : nullptr), &phrase};
  if (phrase.determiner == Determiner::Any) mentions_.emplace_back();  // of several it would be "them"
  return slot;
}

Resolved References::introduced(const NounPhrase& phrase, Box& box) {
  const std::string name = fresh();
  Resolved slot{reference_variable(name), false, restricted(phrase, name), &phrase};
  box.variables.emplace_back(name, slot.domain);
  referents_.push_back(
      {name, phrase.noun, phrase.by_function || phrase.noun.kind == Domain::Kind::Object, is_definite(phrase)});
  mentions_.push_back(name);
  return slot;
}

Resolved References::given(const NounPhrase& phrase, Box& box) {
  Resolved slot = introduced(phrase, box);
  referents_.back().definite = phrase.determiner == Determiner::The;
  return slot;
}

Formula quantified(const Resolved& slot, Formula body) {
  Formula f;
  f.variable = slot.term.name;
  f.domain = slot.domain;
  f.children.push_back(std::move(body));
  f.number = slot.phrase->number;
  switch (slot.phrase->determiner) {
    case Determiner::Every:
      f.op = Op::Forall;
      break;
    case Determiner::Exactly:
      f.op = Op::Count, f.comparison = Comparison::Equal;
      break;
    case Determiner::AtLeast:
      f.op = Op::Count, f.comparison = Comparison::AtLeast;
      break;
    case Determiner::AtMost:
      f.op = Op::Count, f.comparison = Comparison::AtMost;
      break;
    default:
      f.op = Op::Exists, f.number = 0;
  }
  return slot.phrase->determiner == Determiner::No ? negation(std::move(f)) : f;
}

Formula said_of(const Complement& complement, const Term& subject, const Resolved* object) {
  Formula f;
  f.op = Op::Atom;
  f.predicate = complement.predicate;
  f.terms.push_back(subject);
  if (object != nullptr) f.terms.push_back(object->term);
  if (complement.converse) std::reverse(f.terms.begin(), f.terms.end());
  if (!complement.symbol.empty()) f.terms.push_back({Term::Kind::Symbol, complement.symbol});
  if (object != nullptr && object->local) f = quantified(*object, std::move(f));
  return complement.negated ? negation(std::move(f)) : f;
}

Resolved References::bound(const NounPhrase& phrase) {
  const std::string name = fresh();
  Resolved slot{reference_variable(name), true, restricted(phrase, name), &phrase};
  referents_.push_back({name, phrase.noun, phrase.noun.kind == Domain::Kind::Object, false});
  return slot;
}

void References::leave(std::size_t before) {
  for (std::size_t i = before; i < referents_.size(); ++i)
    if (!referents_[i].definite) hidden_.push_back(referents_[i].noun);
  referents_.resize(before);
}

}  // namespace unietp
