#include "annotator/compose.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace unietp {
namespace {

using Op = Formula::Op;

/// A noun phrase after resolution: a term, or a quantifier that is still to be put around what is said of it.
struct Slot {
  Term term;
  bool local = false;  // quantified right around its atom or clause
  Domain domain;
  const NounPhrase* phrase = nullptr;
};

/// Where existential variables go: the text, or one alternative of an `or`.
struct Box {
  std::vector<std::pair<std::string, Domain>> variables;
  std::vector<Formula> distinct;
};

struct Referent {
  std::string variable;
  Domain noun;
  bool vague = false;  // "that object" may mean it
};

Formula all_of(std::vector<Formula> parts) { return conjunction(std::move(parts)); }

Formula any_of_parts(std::vector<Formula> parts) {
  if (parts.size() == 1) return std::move(parts.front());
  Formula f;
  f.op = Op::Or;
  f.children = std::move(parts);
  return f;
}

Formula wrapped(Op op, std::vector<Formula> children) {
  Formula f;
  f.op = op;
  f.children = std::move(children);
  return f;
}

class Composer {
 public:
  Result<Formula> compose(const Message& message) {
    Box text;
    std::vector<Formula> parts;
    for (const Requirement& requirement : message) {
      add(requirement, text, parts);
      if (error_) return *error_;
    }
    if (parts.empty()) {
      fail(1, "the text asks for nothing; a sentence such as \"Put a mug on a table.\" is accepted");
      return *error_;
    }
    return boxed(text, all_of(std::move(parts)));
  }

 private:
  void fail(int column, std::string message) {
    if (!error_) error_ = Error{Error::Kind::Parse, "instruction", {1, column}, std::move(message)};
  }

  static Formula boxed(const Box& box, Formula body) {
    std::vector<Formula> parts = box.distinct;
    parts.push_back(std::move(body));
    Formula f = all_of(std::move(parts));
    for (auto i = box.variables.rbegin(); i != box.variables.rend(); ++i) f = exists(i->first, i->second, std::move(f));
    return f;
  }

  void add(const Requirement& requirement, Box& text, std::vector<Formula>& parts) {
    if (requirement.kind == Requirement::Kind::Choose) {
      for (const NounPhrase& phrase : requirement.clauses[0].subjects) resolve(phrase, text);
      return;
    }
    if (!requirement.clauses[0].given.empty()) {
      parts.push_back(conditional(requirement.clauses[0]));
      return;
    }
    std::vector<Formula> said;
    for (const Clause& clause : requirement.clauses) said.push_back(state(clause, text));
    if (requirement.inverted) std::swap(said[0], said[1]);
    switch (requirement.kind) {
      case Requirement::Kind::Choose:
        break;
      case Requirement::Kind::Final:
      case Requirement::Kind::Need:
        parts.push_back(at_end(said[0]));
        break;
      case Requirement::Kind::Sometime:
        parts.push_back(wrapped(Op::Sometime, {said[0]}));
        break;
      case Requirement::Kind::Always:
        parts.push_back(wrapped(Op::Always, {said[0]}));
        break;
      case Requirement::Kind::Until:
        parts.push_back(wrapped(Op::Until, {said[0], said[1]}));
        break;
      case Requirement::Kind::Before:
        parts.push_back(wrapped(Op::Before, {said[0], said[1]}));
        break;
      case Requirement::Kind::ThenKept:
        parts.push_back(at_end(said[0]));
        [[fallthrough]];
      case Requirement::Kind::Then:
        parts.push_back(wrapped(Op::Before, {said[0], said[1]}));
        parts.push_back(at_end(said[1]));
        break;
      case Requirement::Kind::Again:
        parts.push_back(wrapped(Op::Sometime, {said[0]}));
        parts.push_back(at_end(said[1]));
        break;
    }
  }

  /// "if a fridge is open, close a cabinet": what is named in it is named for this sentence only.
  Formula conditional(const Clause& clause) {
    const std::size_t before = referents_.size();
    Box condition, own;
    for (const NounPhrase& there : clause.given) introduced(there, condition);
    leave(before);
    Formula then = state(clause, own);
    leave(before);
    return any_of_parts({negation(boxed(condition, conjunction({}))), at_end(boxed(own, std::move(then)))});
  }

  static std::string numbered(int number) { return std::string("n").append(std::to_string(number)); }
  std::string fresh() { return numbered(++count_); }

  static Term variable(const std::string& name) { return {Term::Kind::Variable, name}; }

  std::vector<const Referent*> named(const Domain& noun) const {
    std::vector<const Referent*> found;
    for (const Referent& referent : referents_)
      if (referent.noun == noun || (noun.kind == Domain::Kind::Object && referent.vague)) found.push_back(&referent);
    return found;
  }

  bool hidden(const Domain& noun) const { return std::find(hidden_.begin(), hidden_.end(), noun) != hidden_.end(); }

  Domain restricted(const NounPhrase& phrase, const std::string& name) {
    Domain domain = phrase.noun;
    std::vector<Formula> where;
    for (const Complement& modifier : phrase.modifiers) where.push_back(restriction(modifier, variable(name)));
    if (!where.empty()) domain.where.push_back(all_of(std::move(where)));
    return domain;
  }

  /// "that is on a desk": the desk is any desk, and is not a referent of the text.
  Formula restriction(const Complement& modifier, const Term& subject) {
    if (modifier.object.empty()) return said_of(modifier, subject, nullptr);
    const NounPhrase& phrase = modifier.object[0];
    Slot slot;
    slot.phrase = &phrase;
    switch (phrase.determiner) {
      case Determiner::Known:
      case Determiner::It:
      case Determiner::Ordinal:
        slot.term = known(phrase);
        break;
      case Determiner::The:
        if (!named(phrase.noun).empty()) fail(phrase.column, "which one is meant is not clear; say 'that …' or 'a …'");
        [[fallthrough]];
      case Determiner::New:
      case Determiner::Single:
      case Determiner::Any: {
        const std::string name = fresh();
        hidden_.push_back(phrase.noun);
        slot = {variable(name), true, restricted(phrase, name), &phrase};
        break;
      }
      default:
        fail(phrase.column, "a description may only name one other object");
    }
    return said_of(modifier, subject, &slot);
  }

  Term known(const NounPhrase& phrase) {
    if (phrase.determiner == Determiner::It) {
      if (referents_.size() == 1) return variable(referents_[0].variable);
      fail(phrase.column, "'it' is clear only after exactly one object was named");
      return {};
    }
    const std::vector<const Referent*> found = named(phrase.noun);
    if (phrase.determiner == Determiner::Ordinal) {
      if (phrase.number <= static_cast<int>(found.size())) return variable(found[phrase.number - 1]->variable);
      fail(phrase.column, "fewer objects of this kind were named before");
      return {};
    }
    if (found.size() == 1) return variable(found[0]->variable);
    fail(phrase.column, found.empty() ? "no such object was named before" : "several such objects were named before");
    return {};
  }

  Slot resolve(const NounPhrase& phrase, Box& box) {
    Slot slot;
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
          same.terms = {variable(next), variable(other->variable)};
          box.distinct.push_back(negation(same));
        }
        return introduced(phrase, box);
      }
      default:
        break;
    }
    const std::string name = fresh();
    hidden_.push_back(phrase.noun);
    slot = {variable(name), true, restricted(phrase, name), &phrase};
    return slot;
  }

  Slot introduced(const NounPhrase& phrase, Box& box) {
    const std::string name = fresh();
    Slot slot{variable(name), false, restricted(phrase, name), &phrase};
    box.variables.emplace_back(name, slot.domain);
    referents_.push_back({name, phrase.noun, phrase.by_function || phrase.noun.kind == Domain::Kind::Object});
    return slot;
  }

  static Formula quantify(const Slot& slot, Formula body) {
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

  static Formula said_of(const Complement& complement, const Term& subject, const Slot* object) {
    Formula f;
    f.op = Op::Atom;
    f.predicate = complement.predicate;
    f.terms.push_back(subject);
    if (object != nullptr) f.terms.push_back(object->term);
    if (complement.converse) std::reverse(f.terms.begin(), f.terms.end());
    if (!complement.symbol.empty()) f.terms.push_back({Term::Kind::Symbol, complement.symbol});
    if (object != nullptr && object->local) f = quantify(*object, std::move(f));
    return complement.negated ? negation(std::move(f)) : f;
  }

  Formula state(const Clause& clause, Box& box) {
    switch (clause.kind) {
      case Clause::Kind::And: {
        std::vector<Formula> parts;
        for (const Clause& part : clause.parts) parts.push_back(state(part, box));
        return all_of(std::move(parts));
      }
      case Clause::Kind::Or: {
        std::vector<Formula> parts;
        for (const Clause& part : clause.parts) {
          Box own;
          const std::size_t before = referents_.size();
          for (const NounPhrase& there : part.given) introduced(there, own);
          Formula f = state(part, own);
          parts.push_back(boxed(own, std::move(f)));
          leave(before);
        }
        return any_of_parts(std::move(parts));
      }
      case Clause::Kind::Compare:
        return compared(clause, box);
      case Clause::Kind::Simple:
        break;
    }
    return simple(clause, box);
  }

  /// Objects of an alternative cannot be referred to after it.
  void leave(std::size_t before) {
    for (std::size_t i = before; i < referents_.size(); ++i) hidden_.push_back(referents_[i].noun);
    referents_.resize(before);
  }

  Formula compared(const Clause& clause, Box& box) {
    Formula f;
    f.op = Op::CountCompare;
    f.comparison = clause.comparison;
    for (std::size_t i = 0; i < 2; ++i) {
      const std::string name = fresh();
      Formula side;
      side.op = Op::Number;
      side.variable = name;
      side.domain = restricted(clause.subjects[i], name);
      const std::vector<Slot> objects = objects_of({clause.complements[i]}, clause, box);
      side.children = {said_of(clause.complements[i], variable(name), objects[0].phrase ? &objects[0] : nullptr)};
      f.children.push_back(std::move(side));
    }
    return f;
  }

  std::vector<Slot> objects_of(const std::vector<Complement>& complements, const Clause& clause, Box& box) {
    bool every = false, none = false;
    for (const NounPhrase& subject : clause.subjects) {
      every |= subject.determiner == Determiner::Every && clause.kind == Clause::Kind::Simple;
      none |= subject.determiner == Determiner::No && !clause.removal;
    }
    std::vector<Slot> slots;
    for (const Complement& complement : complements) {
      if (complement.object.empty()) {
        slots.emplace_back();
        continue;
      }
      const NounPhrase& phrase = complement.object[0];
      const std::size_t before = referents_.size();
      slots.push_back(resolve(phrase, box));
      const bool opened = referents_.size() > before;
      if (opened && (none || (every && phrase.determiner == Determiner::New)))
        fail(phrase.column, "whether this is one and the same object is not clear; 'any …' or 'a single …' is");
      if (opened && complement.negated) fail(phrase.column, "'not … a' has two readings; 'any …' has one");
    }
    return slots;
  }

  Formula simple(const Clause& clause, Box& box) {
    std::vector<Slot> subjects;
    std::vector<Box> own(clause.subjects.size());
    const bool alternatives = clause.any_subject && clause.subjects.size() > 1;
    const std::size_t before = referents_.size();
    for (std::size_t i = 0; i < clause.subjects.size(); ++i)
      subjects.push_back(resolve(clause.subjects[i], alternatives ? own[i] : box));
    if (alternatives) leave(before);
    const std::vector<Slot> objects = objects_of(clause.complements, clause, box);
    std::vector<Formula> parts;
    for (std::size_t i = 0; i < subjects.size(); ++i) {
      std::vector<Formula> said;
      for (std::size_t k = 0; k < objects.size(); ++k)
        said.push_back(said_of(clause.complements[k], subjects[i].term, objects[k].phrase ? &objects[k] : nullptr));
      Formula f = clause.any_complement ? any_of_parts(std::move(said)) : all_of(std::move(said));
      if (subjects[i].local) f = quantify(subjects[i], std::move(f));
      parts.push_back(boxed(own[i], std::move(f)));
      for (const Complement& done : clause.subjects[i].done)
        parts.push_back(brought_about(done, subjects[i], clause, box));
    }
    return clause.any_subject ? any_of_parts(std::move(parts)) : all_of(std::move(parts));
  }

  /// "that you put a mug into": another thing that the text asks for.
  Formula brought_about(const Complement& done, const Slot& subject, const Clause& clause, Box& box) {
    const NounPhrase& phrase = done.object[0];
    const Slot object = resolve(phrase, box);
    if (subject.local || object.local || clause.any_subject) fail(phrase.column, "which ones are meant is not clear");
    return said_of(done, subject.term, &object);
  }

  std::vector<Referent> referents_;
  std::vector<Domain> hidden_;  // named, but not to be referred to
  int count_ = 0;
  std::optional<Error> error_;
};

}  // namespace

Result<Formula> compose(const Message& message) { return Composer().compose(message); }

}  // namespace unietp
