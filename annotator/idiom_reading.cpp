#include "annotator/clause_reading.h"

// What people say otherwise than clause by clause.
namespace unietp {
namespace {

using P = Predicate;

NounPhrase named_again(const NounPhrase& phrase) {
  NounPhrase again;
  again.determiner = Determiner::Known;
  again.noun = phrase.noun;
  again.column = phrase.column;
  return again;
}

}  // namespace

/// "divide all the mugs between the desk and the shelf, with at least one on each"
Clause ClauseReader::shared_out() {
  Clause clause;
  clause.subjects.push_back(words_.phrase());
  if (clause.subjects[0].determiner != Determiner::Every) words_.fail("expected 'all the …' before this");
  words_.expect("between");
  clause.complements.push_back({P::On, false, "", {words_.phrase()}});
  words_.expect("and");
  clause.complements.push_back({P::On, false, "", {words_.phrase()}});
  for (Complement& place : clause.complements)
    if (place.object[0].determiner == Determiner::New) place.object[0].determiner = Determiner::Single;
  words_.accept(", with at least one on each");
  clause.any_complement = clause.each_has_one = true;
  return clause;
}

/// "swap the book on the couch and the magazine on the table": each goes where the other is.
Clause ClauseReader::swapped() {
  Clause both;
  both.kind = Clause::Kind::And;
  both.parts.resize(2);
  for (Clause& part : both.parts) {
    if (&part != &both.parts[0] && words_.accept_one({"and", "with"}) < 0) words_.fail("expected 'and'");
    words_.set_bare_places(true);
    part.subjects.push_back(words_.phrase());
    words_.set_bare_places(false);
    const auto& where = part.subjects[0].modifiers;
    const bool placed = where.size() == 1 && describes_by_place(where[0]) && !where[0].negated &&
                        where[0].object[0].determiner == Determiner::The && where[0].object[0].modifiers.empty();
    if (!placed) words_.fail("expected what stands on or in the one of its kind, such as 'the mug on the desk'");
  }
  if (words_.failed()) return both;
  for (std::size_t i = 0; i < 2; ++i) both.parts[i].complements = both.parts[1 - i].subjects[0].modifiers;
  return both;
}

/// "put one of the mugs on the desk and the other one on the shelf": there are two, and one is on each. "… and leave
/// the other one on the shelf" says so by equal numbers.
Clause ClauseReader::one_on_each() {
  Clause clause;
  clause.subjects.push_back(words_.bare_noun());
  clause.complements.push_back(words_.complement());
  const bool stays = words_.accept("and leave the other one");
  if (!stays) words_.expect("and the other one");
  clause.complements.push_back(words_.complement());
  for (const Complement& place : clause.complements)
    if (place.predicate != P::On || place.negated) words_.fail("expected 'on …' before this");
  for (Complement& place : clause.complements)
    if (!words_.failed() && place.object[0].determiner == Determiner::New)
      place.object[0].determiner = Determiner::Single;
  clause.each_has_one = true;
  if (stays) {
    clause.kind = Clause::Kind::Compare;
    clause.subjects.push_back(clause.subjects[0]);
    std::swap(clause.complements[0], clause.complements[1]);  // the one that moves is said last of equal numbers
    return clause;
  }
  clause.subjects[0].determiner = Determiner::Every;
  clause.subjects[0].promised = 2;
  clause.any_complement = true;
  return clause;
}

/// "split the mugs evenly between the desk and the shelf"
Clause ClauseReader::split_evenly() {
  Clause clause;
  clause.kind = Clause::Kind::Compare;
  clause.subjects.assign(2, words_.bare_noun());
  words_.expect("evenly between");
  clause.complements.push_back({P::On, false, "", {words_.phrase()}});
  words_.expect("and");
  clause.complements.push_back({P::On, false, "", {words_.phrase()}});
  clause.each_has_one = true;
  return clause;
}

/// "put the same number of mugs on the desk and on the shelf, with at least one on each"
Clause ClauseReader::same_number() {
  Clause clause;
  clause.kind = Clause::Kind::Compare;
  clause.subjects.assign(2, words_.bare_noun());
  clause.complements.push_back(words_.complement());
  words_.expect("and");
  clause.complements.push_back(words_.complement());
  words_.accept(", with at least one on each");
  clause.each_has_one = true;
  return clause;
}

/// "put more mugs than plates in the sink"
Clause ClauseReader::outnumbering() {
  Clause clause;
  clause.kind = Clause::Kind::Compare;
  clause.comparison = Comparison::Greater;
  clause.subjects.push_back(words_.bare_noun());
  words_.expect("than");
  clause.subjects.push_back(words_.bare_noun());
  at_the_same_place(clause);
  return clause;
}

/// "… than plates in the sink": the place of both.
void ClauseReader::at_the_same_place(Clause& clause) {
  clause.complements.push_back(words_.complement());
  if (clause.complements[0].object.empty()) return words_.fail("expected a place before this");
  Complement again = clause.complements[0];
  again.object = {named_again(again.object[0])};
  clause.complements.push_back(std::move(again));
}

/// "pour it into the vase": what was filled in before; the symbol is that of the clause before.
Clause ClauseReader::poured(std::string symbol) {
  Clause clause;
  clause.poured = true;
  words_.set_bare_rooms(true);
  clause.subjects.push_back(words_.phrase());
  words_.set_bare_rooms(false);
  clause.complements.push_back({P::Filled, false, std::move(symbol), {}});
  return clause;
}

bool ClauseReader::put_down() {
  return words_.accept_one({"and put them down", "and put it down", "and put them somewhere else",
                            "and put it somewhere else", ", put them somewhere else", ", put it somewhere else"}) >= 0;
}

/// "take the mug off the desk and put it in the sink": the mug that is on the desk. "Take the mug off the desk.": the
/// only one there, and none is to be there.
bool ClauseReader::taken_from(Clause& clause) {
  if (clause.subjects.size() != 1 || clause.subjects[0].determiner == Determiner::Every) return false;
  const int from = words_.accept_one({"off", "out of", "from"});
  if (from < 0) return false;
  Complement place{from == 1 ? P::Inside : P::On, false, "", {}};
  if (auto floor = from == 0 ? words_.room_floor() : std::nullopt) {
    place.predicate = P::OnFloor;
    place.object = {*std::move(floor)};
  } else {
    place.object = {words_.place()};
  }
  if (from == 2) {
    if (!is_room(place.object[0].noun)) words_.fail("expected a room before this");
    place.predicate = P::InRoom;
  }
  clause.put_down = put_down();
  if (clause.put_down || words_.accept_one({"and put it", "and place it", "and put them"}) < 0) {
    if (from == 2) words_.fail("expected 'and put it'");
    clause.removal = true;
    NounPhrase& taken = clause.subjects[0];
    const bool only = taken.determiner == Determiner::The && taken.modifiers.empty();
    place.negated = !only;
    if (only) taken.determiner = Determiner::No, taken.promised = 1;
    clause.complements.push_back(std::move(place));
    return true;
  }
  clause.subjects[0].modifiers.push_back(std::move(place));
  placed(clause);
  return true;
}

/// "don't leave any mugs on the desk", "don't leave the inhaler on any desk"
Clause ClauseReader::none_left(bool any) {
  Clause clause;
  if (!any) {
    clause.subjects.push_back(words_.phrase());
    clause.complements.push_back(words_.complement());
    clause.complements[0].negated = !clause.complements[0].negated;
    if (clause.complements[0].object.empty()) words_.fail("expected a place before this");
    return clause;
  }
  clause.subjects.push_back(words_.complement_comes() ? words_.last_moved() : words_.bare_noun());
  clause.subjects[0].determiner = Determiner::No;
  words_.complements(clause);
  return clause;
}

/// What follows "don't leave more than" or "leave no more than", "one on the desk", or "only": "one can stay on the
/// desk".
Clause ClauseReader::few_left() {
  Clause clause;
  const int most = words_.number();
  words_.accept("can stay");
  clause.subjects.push_back(words_.complement_comes() ? words_.last_moved() : words_.bare_noun(most != 1));
  clause.subjects[0].determiner = Determiner::AtMost;
  clause.subjects[0].number = most;
  words_.complements(clause);
  return clause;
}

/// "leave exactly one mug on the desk and put the others somewhere else", "leave no mug on any desk", "leave it open"
Clause ClauseReader::remaining() {
  if (words_.accept("no more than")) return few_left();
  Clause clause;
  const bool open = words_.comes("it open");
  clause.subjects.push_back(words_.phrase());
  words_.complements(clause);
  if (open) return clause;
  const Determiner determiner = clause.subjects[0].determiner;
  if (determiner == Determiner::No) return clause;
  if (determiner != Determiner::Exactly) words_.fail("expected 'exactly …' or 'no …' before this");
  const bool other = words_.accept("and put the other one somewhere else");
  if (other) clause.subjects[0].promised = 2;
  if (!other) words_.expect("and put the others somewhere else");
  clause.put_down = true;
  return clause;
}

bool ClauseReader::left_alone(Clause& clause) {
  const int others =
      words_.accept_one({"do not open any of the others", "leave the others closed", "do not open the other one",
                         "leave the other one closed", "don't open the others", "don't open the other one"});
  if (others >= 0) {
    NounPhrase rest = words_.last_noun();
    rest.determiner = Determiner::Every;
    rest.modifiers.push_back({P::Closed, false, "", {}});
    clause.subjects.push_back(std::move(rest));
    clause.complements.push_back({P::Closed, false, "", {}});
    return true;
  }
  if (words_.accept_one({"leave the one", "leave the ones"}) >= 0) {  // of what was moved
    NounPhrase those = words_.last_moved();
    those.determiner = Determiner::Every;
    Complement place = words_.complement();
    for (NounPhrase& object : place.object) {
      if (object.determiner == Determiner::The) object.determiner = Determiner::Any;
    }
    those.modifiers.push_back(place);
    clause.subjects.push_back(std::move(those));
    clause.complements.push_back(std::move(place));
    if (words_.accept_one({"where it is", "where they are"}) < 0) words_.fail("expected 'where it is' before this");
    return true;
  }
  if (words_.accept_one({"do not open", "don't open"}) >= 0) {
    clause.subjects.push_back(words_.phrase());
    if (words_.accept(", it's still running")) {  // the one that is on
      clause.subjects[0].determiner = Determiner::Every;
      clause.subjects[0].modifiers.push_back({P::PowerOn, false, "", {}});
    }
    if (clause.subjects[0].determiner == Determiner::Any) clause.subjects[0].determiner = Determiner::Every;
    clause.complements.push_back({P::Closed, false, "", {}});
    return true;
  }
  for (const std::string_view all : {"leave all", "leave every", "leave each", "leave both", "leave the"}) {
    if (!words_.comes(all)) continue;
    words_.accept("leave");
    clause.subjects.push_back(words_.phrase());
    words_.complements(clause);
    // "Leave the pen on the end table.": on one of these.
    for (Complement& said : clause.complements)
      for (NounPhrase& place : said.object)
        if (place.determiner == Determiner::The) place.determiner = Determiner::Any;
    return true;
  }
  return false;
}

}  // namespace unietp
