#include "annotator/compose.h"

#include <algorithm>
#include <utility>

#include "annotator/compose_proposition.h"
#include "annotator/meaning.h"
#include "annotator/references.h"
#include "scene/states.h"

namespace unietp {
namespace {

using Op = Formula::Op;

Term variable(const std::string& name) { return {Term::Kind::Variable, name}; }

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

/// Where a thing is.
bool is_place(Predicate predicate) {
  using P = Predicate;
  return predicate == P::On || predicate == P::Inside || predicate == P::NextTo || predicate == P::Under ||
         predicate == P::OnFloor || predicate == P::InRoom || predicate == P::Held;
}

/// "First put a mug on a table, then wash it" leaves it there, "…, then put it in a sink" does not: what was done lasts
/// unless what follows is another place or the opposite state of the same thing.
bool lasts(const Formula& done, const Formula& next) {
  if (next.op != Op::Atom)
    return std::all_of(next.children.begin(), next.children.end(), [&](const Formula& f) { return lasts(done, f); });
  if (done.op != Op::Atom)
    return std::all_of(done.children.begin(), done.children.end(), [&](const Formula& f) { return lasts(f, next); });
  if (done.terms[0] != next.terms[0]) return true;
  if (is_place(done.predicate) && is_place(next.predicate)) return false;
  return opposite_of(done.predicate) != next.predicate;
}

class Composer {
 public:
  explicit Composer(WordChoices& choices) : references_(choices) {}

  Result<Reading> compose(const Message& message) {
    Box text;
    std::vector<Formula> parts;
    for (const Requirement& requirement : message) {
      add(requirement, text, parts);
      if (references_.error()) return *references_.error();
    }
    if (parts.empty()) {
      references_.fail(1, "the text asks for nothing; a sentence such as \"Put a mug on a table.\" is accepted");
      return *references_.error();
    }
    parts.insert(parts.end(), excepted_.begin(), excepted_.end());
    Formula all = conjunction(std::move(parts));
    // What was only mentioned is not asked for.
    std::erase_if(text.variables, [&](const auto& variable) {
      return std::find(mentioned_.begin(), mentioned_.end(), variable.first) != mentioned_.end() &&
             !mentions(all, variable.first);
    });
    return Reading{boxed(text, std::move(all)), std::move(facts_)};
  }

 private:
  void add(const Requirement& requirement, Box& text, std::vector<Formula>& parts) {
    if (requirement.kind == Requirement::Kind::Choose) {
      for (const NounPhrase& phrase : requirement.clauses[0].subjects) references_.resolve(phrase, text);
      return;
    }
    if (requirement.kind == Requirement::Kind::Fact) return add_fact(requirement.clauses[0], text);
    if (requirement.kind == Requirement::Kind::Stated) {
      parts.push_back(compose_proposition(requirement.stated[0], references_));
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
        if (requirement.kind == Requirement::Kind::Then && lasts(said[0], said[1])) parts.push_back(at_end(said[0]));
        parts.push_back(wrapped(Op::Before, {said[0], said[1]}));
        parts.push_back(at_end(said[1]));
        break;
      case Requirement::Kind::Fact:
      case Requirement::Kind::Stated:
        break;
      case Requirement::Kind::Again:
        parts.push_back(wrapped(Op::Sometime, {said[0]}));
        parts.push_back(at_end(said[1]));
        break;
    }
  }

  /// "There is a dirty mug on the desk.": it can be spoken of from now on. "There is more than one mug here.": none
  /// can. "The lamp in the bedroom is on.": there is one such lamp.
  void add_fact(const Clause& clause, Box& text) {
    NounPhrase phrase = clause.subjects[0];
    const bool the = phrase.determiner == Determiner::The;
    if (!the) phrase.modifiers.insert(phrase.modifiers.end(), clause.complements.begin(), clause.complements.end());
    Resolved slot;
    if (phrase.determiner == Determiner::AtLeast) {
      const std::string name = references_.fresh();
      slot = {variable(name), true, references_.restricted(phrase, name), &phrase};
      facts_.push_back(quantified(slot, conjunction({})));
      return;
    }
    if (!the && phrase.determiner != Determiner::New && phrase.determiner != Determiner::Single)
      return references_.fail(phrase.column, "expected 'a …' or 'the …' in what is said to be so");
    slot = references_.introduced(phrase, text);
    mentioned_.push_back(slot.term.name);
    std::vector<Formula> so;
    if (the) {
      Formula one;
      one.op = Op::Count;
      one.number = 1;
      one.variable = slot.term.name;
      one.domain = slot.domain;
      one.children = {conjunction({})};
      facts_.push_back(std::move(one));
      const std::vector<Resolved> objects = objects_of(clause.complements, clause, text);
      for (std::size_t k = 0; k < objects.size(); ++k)
        so.push_back(said_of(clause.complements[k], slot.term, objects[k].phrase ? &objects[k] : nullptr));
    }
    facts_.push_back(exists(slot.term.name, slot.domain, conjunction(std::move(so))));
  }

  /// "Put every mug but the red one on the table.": the red one is never there.
  void leave_out(const Resolved& subject, const Formula& said) {
    Resolved left = subject;
    left.domain.where = {without_double_negation(negation(subject.domain.where[0]))};
    Formula never;
    never.op = Op::Always;
    never.children = {forall(left.term.name, left.domain, negation(said))};
    excepted_.push_back(std::move(never));
  }
  static Formula without_double_negation(const Formula& f) {
    return f.op == Op::Not && f.children[0].op == Op::Not ? f.children[0].children[0] : f;
  }

  /// "if a fridge is open, close a cabinet": what is named in it is named for this sentence only.
  Formula conditional(const Clause& clause) {
    const std::size_t before = references_.named_count();
    Box condition, own;
    for (const NounPhrase& there : clause.given) references_.given(there, condition);
    references_.leave(before);
    Formula then = state(clause, own);
    references_.leave(before);
    return any_of_parts({negation(boxed(condition, conjunction({}))), at_end(boxed(own, std::move(then)))});
  }

  Formula state(const Clause& clause, Box& box) {
    switch (clause.kind) {
      case Clause::Kind::And: {
        std::vector<Formula> parts;
        for (const Clause& part : clause.parts) parts.push_back(state(part, box));
        return conjunction(std::move(parts));
      }
      case Clause::Kind::Or: {
        std::vector<Formula> parts;
        for (const Clause& part : clause.parts) {
          Box own;
          const std::size_t before = references_.named_count();
          for (const NounPhrase& there : part.given) references_.given(there, own);
          Formula f = state(part, own);
          parts.push_back(boxed(own, std::move(f)));
          references_.leave(before);
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

  Formula compared(const Clause& clause, Box& box) {
    Formula f;
    f.op = Op::CountCompare;
    f.comparison = clause.comparison;
    for (std::size_t i = 0; i < 2; ++i) {
      const std::string name = references_.fresh();
      Formula side;
      side.op = Op::Number;
      side.variable = name;
      side.domain = references_.restricted(clause.subjects[i], name);
      const std::vector<Resolved> objects = objects_of({clause.complements[i]}, clause, box);
      side.children = {said_of(clause.complements[i], variable(name), objects[0].phrase ? &objects[0] : nullptr)};
      f.children.push_back(std::move(side));
    }
    return f;
  }

  std::vector<Resolved> objects_of(const std::vector<Complement>& complements, const Clause& clause, Box& box) {
    bool every = false, none = false;
    for (const NounPhrase& subject : clause.subjects) {
      every |= subject.determiner == Determiner::Every && clause.kind == Clause::Kind::Simple;
      none |= subject.determiner == Determiner::No && !clause.removal;
    }
    std::vector<Resolved> slots;
    for (const Complement& complement : complements) {
      if (complement.object.empty()) {
        slots.emplace_back();
        continue;
      }
      const NounPhrase& phrase = complement.object[0];
      const std::size_t before = references_.named_count();
      slots.push_back(references_.resolve(phrase, box));
      const bool opened = references_.named_count() > before;
      if (opened && (none || (every && phrase.determiner == Determiner::New)))
        references_.fail(phrase.column,
                         "whether this is one and the same object is not clear; 'any …' or 'a single …' is");
      if (opened && complement.negated) references_.fail(phrase.column, "'not … a' has two readings; 'any …' has one");
    }
    return slots;
  }

  Formula simple(const Clause& clause, Box& box) {
    std::vector<Resolved> subjects;
    std::vector<Box> own(clause.subjects.size());
    const bool alternatives = clause.any_subject && clause.subjects.size() > 1;
    const std::size_t before = references_.named_count();
    for (std::size_t i = 0; i < clause.subjects.size(); ++i)
      subjects.push_back(references_.resolve(clause.subjects[i], alternatives ? own[i] : box));
    if (alternatives) references_.leave(before);
    const std::vector<Resolved> objects = objects_of(clause.complements, clause, box);
    std::vector<Formula> parts;
    for (std::size_t i = 0; i < subjects.size(); ++i) {
      std::vector<Formula> said;
      for (std::size_t k = 0; k < objects.size(); ++k)
        said.push_back(said_of(clause.complements[k], subjects[i].term, objects[k].phrase ? &objects[k] : nullptr));
      Formula f = clause.any_complement ? any_of_parts(std::move(said)) : conjunction(std::move(said));
      if (clause.subjects[i].except) leave_out(subjects[i], f);
      if (subjects[i].local) f = quantified(subjects[i], std::move(f));
      parts.push_back(boxed(own[i], std::move(f)));
      for (const Complement& done : clause.subjects[i].done)
        parts.push_back(brought_about(done, subjects[i], clause, box));
    }
    return clause.any_subject ? any_of_parts(std::move(parts)) : conjunction(std::move(parts));
  }

  /// "that you put a mug into": another thing that the text asks for.
  Formula brought_about(const Complement& done, const Resolved& subject, const Clause& clause, Box& box) {
    const NounPhrase& phrase = done.object[0];
    const Resolved object = references_.resolve(phrase, box);
    if (subject.local || object.local || clause.any_subject)
      references_.fail(phrase.column, "which ones are meant is not clear");
    return said_of(done, subject.term, &object);
  }

  References references_;
  std::vector<Formula> facts_, excepted_;
  std::vector<std::string> mentioned_;  // variables of facts
};

}  // namespace

Result<Reading> compose(const Message& message, WordChoices& choices) { return Composer(choices).compose(message); }

}  // namespace unietp
