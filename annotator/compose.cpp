#include "annotator/compose.h"

#include <algorithm>
#include <optional>
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

/// "There is a table here. There is a key on it.": puts what is said of a thing into the sentence that brings it in.
/// False when nothing brings it in.
bool join_facts(std::vector<Formula>& facts) {
  for (std::size_t i = facts.size(); i-- > 0;) {
    const auto free = free_variables(facts[i]);
    if (free.empty()) continue;
    const auto about = std::find_if(facts.rbegin() + static_cast<std::ptrdiff_t>(facts.size() - i), facts.rend(),
                                    [&](const Formula& f) { return f.op == Op::Exists && f.variable == free.back(); });
    if (about == facts.rend()) return false;
    about->children = {conjunction({about->children[0], facts[i]})};
    facts.erase(facts.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return true;
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
    parts.insert(parts.end(), cut_.begin(), cut_.end());
    for (const Domain& absent : references_.absent()) {
      const std::string none = references_.fresh();
      facts_.push_back(forall(none, absent, negation(conjunction({}))));
    }
    if (!join_facts(facts_)) {
      references_.fail(1, "what is said to be so is about something that is only asked for");
      return *references_.error();
    }
    Formula all = conjunction(std::move(parts));
    // What was only mentioned is not asked for.
    std::erase_if(text.variables, [&](const auto& variable) {
      return std::find(mentioned_.begin(), mentioned_.end(), variable.first) != mentioned_.end() &&
             !mentions(all, variable.first);
    });
    return Reading{boxed(text, std::move(all)), std::move(facts_), references_.is_strained()};
  }

 private:
  void add(const Requirement& requirement, Box& text, std::vector<Formula>& parts) {
    if (requirement.kind == Requirement::Kind::Choose) {
      for (const NounPhrase& phrase : requirement.clauses[0].subjects) references_.resolve(phrase, text);
      return;
    }
    if (requirement.kind == Requirement::Kind::Fact) return add_fact(requirement.clauses[0], text);
    if (requirement.kind == Requirement::Kind::Contrast) {  // nobody goes on to speak of it
      const std::size_t named = references_.named_count(), mentions = references_.mention_count();
      add_fact(requirement.clauses[0], text);
      references_.forget_mentions(mentions);
      return references_.leave(named);
    }
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
      case Requirement::Kind::Once:  // no text is read as this
        break;
      case Requirement::Kind::Final:
      case Requirement::Kind::Need: {
        Formula last = at_end(std::move(said[0]));  // "open the drawer …, and leave it open" says it twice
        if (std::find(parts.begin(), parts.end(), last) == parts.end()) parts.push_back(std::move(last));
        break;
      }
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
        if (requirement.kind == Requirement::Kind::Then && !uses_up(requirement) && lasts(said[0], said[1]))
          parts.push_back(at_end(said[0]));
        parts.push_back(wrapped(Op::Before, {said[0], said[1]}));
        parts.push_back(at_end(said[1]));
        break;
      case Requirement::Kind::Fact:
      case Requirement::Kind::Contrast:
      case Requirement::Kind::Stated:
        break;
      case Requirement::Kind::Again:
        parts.push_back(wrapped(Op::Sometime, {said[0]}));
        parts.push_back(at_end(said[1]));
        break;
      case Requirement::Kind::UntilThen:
        parts.push_back(wrapped(Op::Until, {said[0], said[1]}));
        parts.push_back(at_end(said[1]));
        parts.push_back(at_end(said[2]));
        break;
      case Requirement::Kind::OnlyThen: {
        std::optional<Formula> none = negated(said[1]);
        if (!none)
          return references_.fail(requirement.clauses[1].subjects[0].column, "expected 'all the …' after 'only then'");
        parts.push_back(wrapped(Op::Until, {std::move(*none), said[0]}));
        parts.push_back(at_end(said[0]));
        parts.push_back(at_end(said[1]));
        break;
      }
    }
  }

  /// "None of them": an atom negated, or what is said of each thing; nullopt for another kind of formula.
  static std::optional<Formula> negated(const Formula& f) {
    if (f.op == Op::Atom) return negation(f);
    if (f.op != Op::Forall) return std::nullopt;
    Formula none = f;
    none.children = {negation(f.children[0])};
    return none;
  }

  /// "Fill the pot, then pour it into a vase.", "Slice a potato, then cook one of the slices.": of the first nothing is
  /// said at the end.
  static bool uses_up(const Requirement& requirement) {
    return std::any_of(requirement.clauses.begin(), requirement.clauses.end(), [](const Clause& clause) {
      const auto cut = [](const Complement& done) { return done.predicate == Predicate::SliceOf; };
      return clause.poured || (!clause.subjects.empty() &&
                               std::any_of(clause.subjects[0].done.begin(), clause.subjects[0].done.end(), cut));
    });
  }

  /// "There is a dirty mug on the desk.": it can be spoken of from now on. "There is more than one mug here.": none
  /// can. "The lamp in the bedroom is on.": there is one such lamp.
  void add_fact(const Clause& clause, Box& text) {
    references_.begin_clause();
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
    const bool beside = std::any_of(phrase.modifiers.begin(), phrase.modifiers.end(),
                                    [](const Complement& said) { return said.predicate == Predicate::NextTo; });
    beside ? references_.mention_several() : references_.mention_again(slot);
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

  /// "if a fridge is open, close a cabinet": what is named in it is named for this sentence only. "If the fridge is
  /// open, close it.": the one that is open.
  Formula conditional(const Clause& clause) {
    const std::size_t before = references_.named_count();
    Box condition, own;
    for (const NounPhrase& there : clause.given) references_.given(there, condition);
    if (!any_phrase(clause, [](const NounPhrase& phrase) { return phrase.determiner == Determiner::It; }))
      references_.leave(before);
    Formula then = at_end(boxed(own, state(clause, own)));
    const auto about = [&](const auto& variable) { return mentions(then, variable.first); };
    if (std::any_of(condition.variables.begin(), condition.variables.end(), about)) then = boxed(condition, then);
    references_.leave(before);
    return any_of_parts({negation(boxed(condition, conjunction({}))), std::move(then)});
  }

  Formula state(const Clause& clause, Box& box) {
    references_.begin_clause();
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
    if (!clause.each_has_one) return f;
    const Formula& last = f.children[1];  // of equal numbers one is enough
    Formula one = exists(last.variable, last.domain, last.children[0]);
    return conjunction({std::move(f), std::move(one)});
  }

  /// "Both mugs" says that there are two, "take the mug off the desk" that one is there.
  void promise(const Resolved& subject, const Clause& clause, const std::vector<Resolved>& objects, const Box& box) {
    const bool other = subject.phrase->determiner == Determiner::Another;
    if (subject.phrase->promised == 0 || (!subject.local && !other)) return;
    Formula there;
    there.op = Op::Count;
    there.number = static_cast<int>(subject.phrase->promised);
    there.variable = other ? references_.fresh() : subject.term.name;
    there.domain = subject.domain;
    there.children = {conjunction({})};
    if (clause.removal || clause.put_down) {
      Formula so = said_of(clause.complements[0], subject.term, &objects[0]);
      for (const auto& [name, domain] : box.variables)
        if (mentions(so, name)) so = exists(name, domain, std::move(so));
      there.domain.where.push_back(std::move(so));
      there.domain.where = {conjunction(std::move(there.domain.where))};
    }
    if (free_variables(there).empty()) facts_.push_back(std::move(there));
  }

  /// "…, and put them down"
  Formula none_held(const Domain& noun) {
    Resolved none{variable(references_.fresh()), true, noun, nullptr};
    const Formula held = said_of({Predicate::Held, false, "", {}}, none.term, nullptr);
    return forall(none.term.name, noun, negation(held));
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
      // "Take the mug off the desk": off the one that it is on.
      const bool any = clause.removal && clause.subjects[0].promised == 1 && phrase.determiner == Determiner::The &&
                       phrase.modifiers.empty() && !references_.is_named(phrase.noun);
      slots.push_back(any ? references_.any_of(phrase, box) : references_.resolve(phrase, box));
      const bool opened = references_.named_count() > before;
      const bool the = phrase.determiner == Determiner::The && phrase.modifiers.empty();
      if (opened && ((none && !the) || (every && phrase.determiner == Determiner::New && !phrase.by_function)))
        references_.fail(phrase.column,
                         "whether this is one and the same object is not clear; 'any …' or 'a single …' is");
      if (opened && complement.negated && !clause.removal)
        references_.fail(phrase.column, "'not … a' has two readings; 'any …' has one");
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
      for (const Complement& done : clause.subjects[i].done) {
        Formula also = brought_about(done, subjects[i], clause, box);
        if (done.predicate == Predicate::SliceOf) {
          cut_.push_back(at_end(std::move(also)));
        } else {
          parts.push_back(std::move(also));
        }
      }
      promise(subjects[i], clause, objects, box);
      if (clause.put_down) parts.push_back(none_held(clause.subjects[i].noun));
      for (std::size_t k = 0; k < objects.size() && clause.each_has_one; ++k) {
        const std::string one = references_.fresh();
        parts.push_back(exists(one, subjects[i].domain, said_of(clause.complements[k], variable(one), &objects[k])));
      }
    }
    references_.set_topic(subjects.size() == 1 && !subjects[0].local ? subjects[0].term.name : "");
    if (clause.put_down && !subjects[0].local) references_.mention_several();  // "…, put it down, and close it"
    return clause.any_subject ? any_of_parts(std::move(parts)) : conjunction(std::move(parts));
  }

  /// "that you put a mug into": another thing that the text asks for.
  Formula brought_about(const Complement& done, const Resolved& subject, const Clause& clause, Box& box) {
    if (done.object.empty()) {  // "a heated potato"
      if (subject.local || clause.any_subject)
        references_.fail(clause.subjects[0].column, "which ones are meant is not clear");
      return said_of(done, subject.term, nullptr);
    }
    const NounPhrase& phrase = done.object[0];
    const Resolved object = references_.resolve(phrase, box);
    if (subject.local || object.local || clause.any_subject)
      references_.fail(phrase.column, "which ones are meant is not clear");
    std::vector<Formula> all{said_of(done, subject.term, &object)};
    for (const Complement& inner : phrase.done) all.push_back(brought_about(inner, object, clause, box));
    references_.mention_again(subject);
    return conjunction(std::move(all));
  }

  References references_;
  std::vector<Formula> facts_, excepted_, cut_;
  std::vector<std::string> mentioned_;  // variables of facts
};

}  // namespace

Result<Reading> compose(const Message& message, WordChoices& choices) { return Composer(choices).compose(message); }

}  // namespace unietp
