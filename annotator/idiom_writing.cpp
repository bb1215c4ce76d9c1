#include "annotator/idiom_writing.h"

#include <algorithm>

#include "annotator/words_for_writing.h"
#include "core/text.h"

namespace unietp {
namespace {

using P = Predicate;
using Text = std::optional<std::string>;

bool is_single(const Clause& clause) {
  return clause.kind == Clause::Kind::Simple && clause.subjects.size() == 1 && clause.complements.size() == 1 &&
         !clause.complements[0].negated;
}

bool is_put(P predicate) { return predicate == P::On || predicate == P::Inside; }

bool says_none_is_somewhere(const Clause& clause) {
  return is_single(clause) && clause.subjects[0].determiner == Determiner::No &&
         (is_put(clause.complements[0].predicate) || clause.complements[0].predicate == P::OnFloor);
}

NounPhrase as(NounPhrase phrase, Determiner determiner) {
  phrase.determiner = determiner;
  return phrase;
}

/// "off the table", "out of it", "off the floor of the kitchen": from every one of several. One thing is taken off the
/// one that it is on.
Text from(const Complement& place, std::size_t there, Naming& naming) {
  const NounPhrase& object = place.object[0];
  const std::string off = place.predicate == P::Inside ? "out of " : "off ";
  const bool all = object.determiner == Determiner::Any && !naming.is_alone(object.noun);
  if (all && object.modifiers.empty() && there == 1) {
    const auto one = naming.singular(object.noun);
    naming.mention_again("");
    return one ? Text(off + "the " + *one) : std::nullopt;
  }
  if (all && object.modifiers.empty()) {
    const auto many = naming.plural(object);
    return many && naming.is_countable(object.noun) ? Text(off + "the " + *many) : std::nullopt;
  }
  auto one = naming.phrase(object, {.beside_every = there != 1});
  if (!one) return std::nullopt;
  if (const auto many = one->text.starts_with("the same ") ? naming.plural(object) : std::nullopt)
    one->text = "one of the " + *many;
  return off + (place.predicate == P::OnFloor ? floor_of(one->text, !object.modifiers.empty()) : one->text);
}

/// "take all the mugs off the table and put them down"
Text taken_away(const Clause& clause, Naming& naming) {
  const Complement& place = clause.complements[0];
  if (naming.keeps_no()) {
    const bool named = naming.was_named_kind(clause.subjects[0].noun);
    const auto any = naming.plural(clause.subjects[0]);
    const Text where = any ? naming.complement(place, {.beside_every = true, .beside_none = true}) : std::nullopt;
    return where && !clause.put_down ? Text("don't leave any " + (named ? "" : *any + " ") + *where) : std::nullopt;
  }
  NounPhrase there = as(clause.subjects[0], Determiner::Every);
  there.there = clause.there_now;
  there.two = there.there == 2;
  const auto all = naming.phrase(there, {.together = true});
  const Text where = all ? from(place, there.there, naming) : std::nullopt;
  if (!where) return std::nullopt;
  const std::string them = all->plural ? "them" : "it";
  if (clause.put_down && !all->plural) naming.mention_again("");  // "…, put it down, and close the fridge again"
  return "take " + all->text + " " + *where + (clause.put_down ? " and put " + them + " somewhere else" : "");
}

Text leaving_one(const Clause& clause, Naming& naming) {
  const auto one = naming.phrase(clause.subjects[0], {});
  const Text where = one ? naming.complement(clause.complements[0], {}) : std::nullopt;
  if (!where) return std::nullopt;
  return "leave " + one->text + " " + *where + " and put the " + (clause.there_now == 2 ? "other one" : "others") +
         " somewhere else";
}

Text shared(const Clause& clause, Naming& naming) {
  const bool even = clause.kind == Clause::Kind::Compare, pair = !even && clause.subjects[0].two;
  const auto things = even || pair ? naming.plural(clause.subjects[0]) : std::nullopt;
  const auto all = even || pair ? std::nullopt : naming.phrase(clause.subjects[0], {.together = true});
  if (even || pair ? !things : !all) return std::nullopt;
  const bool one_moves = even && clause.subjects[0].two;  // of two on the place that is named first
  const std::size_t near = one_moves ? 1 : 0;
  const auto first = naming.phrase(clause.complements[near].object[0], {});
  const auto second = first ? naming.phrase(clause.complements[1 - near].object[0], {}) : std::nullopt;
  if (!second) return std::nullopt;
  if (one_moves)
    return "put one of the " + *things + " on " + first->text + " and leave the other one on " + second->text;
  if (pair) return "put one of the " + *things + " on " + first->text + " and the other one on " + second->text;
  const std::string places = " between " + first->text + " and " + second->text;
  return even ? "split the " + *things + " evenly" + places : "divide " + all->text + places;
}

/// "put more mugs than plates in the sink"
Text outnumbering(const Clause& clause, Naming& naming) {
  const auto more = naming.plural(clause.subjects[0]), fewer = naming.plural(clause.subjects[1]);
  const Text where = more && fewer ? naming.complement(clause.complements[0], {}) : std::nullopt;
  return where ? Text("put more " + *more + " than " + *fewer + " " + *where) : std::nullopt;
}

}  // namespace

bool same_place(const Clause& clause) {
  const Complement &a = clause.complements[0], &b = clause.complements[1];
  return a.predicate == b.predicate && !a.negated && !b.negated && is_put(a.predicate) &&
         !a.object[0].variable.empty() && a.object[0].variable == b.object[0].variable;
}

bool is_idiom(const Clause& clause) {
  if (clause.put_down || clause.each_has_one || clause.poured) return true;
  if (clause.kind == Clause::Kind::Compare) return clause.comparison == Comparison::Greater && same_place(clause);
  return says_none_is_somewhere(clause);
}

std::optional<std::string> idiom(const Clause& clause, Naming& naming) {
  if (clause.poured) {
    const auto into = naming.phrase(clause.subjects[0], {});
    if (into && naming.is_plant(clause.subjects[0].noun) && clause.complements[0].symbol == "water")
      return "water " + into->text;
    return into ? Text("pour it into " + into->text) : std::nullopt;
  }
  if (clause.each_has_one) return shared(clause, naming);
  if (clause.kind == Clause::Kind::Compare) return outnumbering(clause, naming);
  if (clause.subjects[0].determiner == Determiner::Exactly) return leaving_one(clause, naming);
  return taken_away(clause, naming);
}

std::optional<std::string> each_somewhere(const Clause& clause, Naming& naming) {
  const NounPhrase& subject = clause.subjects[0];
  const auto& told = subject.modifiers;
  const bool plain = std::all_of(told.begin(), told.end(), [](const Complement& one) { return one.object.empty(); });
  if (subject.determiner != Determiner::Every || subject.except || !plain || subject.there == 1 ||
      !naming.is_countable(subject.noun))
    return std::nullopt;
  std::vector<std::string> places;
  for (const Complement& said : clause.complements) {
    const NounPhrase& object = said.object[0];
    if (object.determiner != Determiner::Any || !object.modifiers.empty() || !naming.is_countable(object.noun))
      return std::nullopt;
    const auto place = naming.singular(object.noun);
    if (!place) return std::nullopt;
    places.push_back(before_object(said.predicate) + " " +
                     (naming.is_alone(object.noun) ? "the " + *place : with_article(*place)));
  }
  const auto things = naming.phrase(subject, {.together = true});
  if (!things || things->text.find(" that ") != std::string::npos) return std::nullopt;
  if (things->text.starts_with("both ")) return "put " + things->text + " " + join(places, " or ");
  constexpr std::string_view kAll = "all the ";
  if (things->text.starts_with(kAll))
    return "put each of the " + things->text.substr(kAll.size()) + " " + join(places, " or ");
  return std::nullopt;
}

std::optional<std::string> no_more(const Clause& clause, Naming& naming) {
  if (!is_single(clause) || clause.subjects[0].determiner != Determiner::AtMost || clause.subjects[0].number < 1 ||
      !is_put(clause.complements[0].predicate) || !clause.subjects[0].modifiers.empty() ||
      !naming.was_named_kind(clause.subjects[0].noun))
    return std::nullopt;
  const Text where = naming.complement(clause.complements[0], {});
  return where ? Text("only " + number_word(clause.subjects[0].number) + " can stay " + *where) : std::nullopt;
}

namespace {

/// Whether things are told by the place in which they then have to stay.
bool says_the_place(const NounPhrase& things, const Complement& said) {
  if (things.modifiers.size() != 1 || things.modifiers[0].object.size() != 1 || said.object.size() != 1) return false;
  const Complement& told = things.modifiers[0];
  return told.predicate == said.predicate && told.negated == said.negated &&
         told.object[0].noun == said.object[0].noun && said.object[0].modifiers.empty() &&
         told.object[0].modifiers.empty();
}

/// Whether "the one" or "the ones" may stand for it: mugs, and crackers, but not bread.
bool names_several(const Domain& noun, Naming& naming) {
  if (naming.is_countable(noun)) return true;
  const auto name = naming.singular(noun);
  return name && name->ends_with('s') && !name->ends_with("ss");
}

}  // namespace

bool stays_where_it_is_told(const Clause& clause, Naming& naming) {
  return is_single(clause) && clause.subjects[0].determiner == Determiner::Every &&
         says_the_place(clause.subjects[0], clause.complements[0]) && !names_several(clause.subjects[0].noun, naming);
}

std::optional<std::string> left_alone(const Clause& clause, Naming& naming) {
  if (!is_single(clause) || naming.keeps_no()) return std::nullopt;
  const NounPhrase& subject = clause.subjects[0];
  const Complement& said = clause.complements[0];
  if (subject.determiner == Determiner::Every && says_the_place(subject, said) && naming.was_named_kind(subject.noun)) {
    if (!names_several(subject.noun, naming)) return std::nullopt;
    const Text where = naming.complement(subject.modifiers[0], {});
    if (!where) return std::nullopt;
    return subject.there == 1 && naming.is_countable(subject.noun) ? "leave the one " + *where + " where it is"
                                                                   : "leave the ones " + *where + " where they are";
  }
  if (subject.determiner == Determiner::Every && said.predicate == P::On && naming.distracts()) {
    const auto all = naming.phrase(subject, {.together = true});
    Complement place = said;
    const bool one = subject.there == 1 && place.object[0].determiner == Determiner::Any;
    if (one) place.object[0].determiner = Determiner::New;
    const Text where = all ? naming.complement(place, {.beside_every = !one, .unique = one}) : std::nullopt;
    return where ? Text("leave " + all->text + " " + *where) : std::nullopt;
  }
  if (said.predicate != P::Closed || !said.object.empty()) return std::nullopt;
  if (subject.determiner == Determiner::Every && naming.is_alone(subject.noun) && subject.modifiers.empty()) {
    const auto one = naming.phrase(as(subject, Determiner::Any), {});
    return one ? Text("do not open " + one->text) : std::nullopt;
  }
  if (subject.determiner != Determiner::Every) return std::nullopt;
  const bool running = subject.modifiers.size() == 1 && subject.modifiers[0].predicate == P::PowerOn &&
                       !subject.modifiers[0].negated && naming.is_alone(subject.noun);
  if (running) {
    NounPhrase machine = as(subject, Determiner::Any);
    machine.modifiers.clear();
    const auto one = naming.phrase(machine, {});
    return one ? Text("don't open " + one->text + ", it's still running") : std::nullopt;
  }
  if (subject.modifiers.size() == 1 && subject.modifiers[0].predicate == P::Closed && !subject.modifiers[0].negated &&
      naming.was_named_kind(subject.noun))
    return subject.there == 1 ? "leave the other one closed" : "leave the others closed";
  const auto any = naming.phrase(as(subject, Determiner::Any), {});
  return any ? Text("do not open " + any->text) : std::nullopt;
}

}  // namespace unietp
