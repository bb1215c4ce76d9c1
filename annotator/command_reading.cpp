#include "annotator/clause_reading.h"
#include "annotator/words_for_reading.h"

namespace unietp {
namespace {

using P = Predicate;

}  // namespace

/// One imperative, or several after "either".
Clause ClauseReader::command() {
  if (words_.comes("either")) {
    words_.accept("either");
    Clause either;
    either.kind = Clause::Kind::Or;
    do {
      either.parts.push_back(given(command_list()));
    } while (!words_.failed() && words_.accept_one({", or", "or"}) >= 0);
    if (either.parts.size() < 2) words_.fail("expected 'or' after 'either'");
    return either;
  }
  if (assurance_comes()) return statements();
  if (words_.accept_one({"go to", "walk over to", "walk to"}) >= 0) return reached();
  if (words_.accept_one({"bring me", "get me", "fetch me"}) >= 0) return with_state(P::Held, false, "");
  if (words_.accept_one({"dust off", "dust"}) >= 0) return with_state(P::Covered, true, "dust");
  if (words_.accept("do not hold")) {
    Clause clause;
    clause.subjects.push_back(words_.phrase());
    if (clause.subjects[0].determiner != Determiner::Any) words_.fail("expected 'any …' before this");
    clause.subjects[0].determiner = Determiner::No;
    clause.complements.push_back({P::Held, false, "", {}});
    return clause;
  }
  if (words_.accept("swap")) return swapped();
  if (words_.accept("divide")) return shared_out();
  if (words_.accept("split the")) return split_evenly();
  if (words_.comes("put one of the") &&
      (words_.follows("and the other one") || words_.follows("and leave the other one"))) {
    words_.accept("put one of the");
    return one_on_each();
  }
  if (words_.accept("put the same number of")) return same_number();
  if (words_.accept("put more")) return outnumbering();
  if (words_.accept("pour it into")) return poured("");  // of what was filled before
  if (words_.accept("water")) return poured("water");
  if (words_.accept_one({"don't leave any", "do not leave any"}) >= 0) return none_left(true);
  if (words_.accept_one({"don't leave more than", "only"}) >= 0) return few_left();
  if (words_.accept_one({"don't leave", "do not leave"}) >= 0) return none_left(false);
  if (words_.accept("leave")) return remaining();
  if (words_.accept("put the lid on")) {
    Clause clause;
    clause.subjects = words_.phrases(clause.any_subject);
    clause.complements.push_back({P::Closed, false, "", {}});
    return clause;
  }
  const bool repeated = moving_ && words_.phrase_comes();  // "put a mug on a table and a bowl in a box"
  moving_ = repeated || words_.accept_one({"put", "place", "set"}) >= 0;
  if (moving_) return moved();
  if (words_.accept_one({"move", "transfer", "carry"}) >= 0) return moved_to();
  if (words_.accept_one({"remove", "take", "get", "fetch", "bring"}) >= 0) return taken();
  if (words_.accept("fill")) return with_symbol(P::Filled);
  if (words_.accept("cover")) return with_symbol(P::Covered);
  if (words_.accept("pour")) return symbol_first(P::Filled, "into", false);
  if (words_.accept("spread")) return symbol_first(P::Covered, "over", false);
  if (words_.accept("drizzle")) return symbol_first(P::Covered, "over", false);
  if (words_.accept("sprinkle")) return symbol_first(P::Covered, "on", false);
  if (words_.accept("wipe the")) return symbol_first(P::Covered, "off", true);
  if (words_.accept("attach")) {
    Clause clause;
    clause.subjects = words_.phrases(clause.any_subject);
    words_.expect("to");
    clause.complements.push_back({P::Attached, false, "", {words_.phrase()}});
    return clause;
  }
  return changed();
}

Clause ClauseReader::command_list() {
  Clause list;
  list.kind = Clause::Kind::And;
  list.parts.push_back(command());
  while (!words_.failed() && words_.accept("and")) list.parts.push_back(command());
  if (list.parts.size() > 1) return list;
  Clause only = std::move(list.parts[0]);
  return only;
}

Clause ClauseReader::reached() {
  Clause clause;
  NounPhrase you;
  you.determiner = Determiner::Agent;
  clause.subjects.push_back(you);
  clause.complements.push_back({P::InRoom, false, "", {words_.phrase()}});
  return clause;
}

Clause ClauseReader::moved() {
  Clause clause;
  const bool each = words_.comes("each of the"), both = words_.comes("both");
  words_.set_results(true);
  if (!words_.both_again(clause.subjects)) clause.subjects = words_.phrases(clause.any_subject);
  words_.set_results(false);
  if (!clause.subjects.empty()) words_.set_moved(clause.subjects[0].noun);
  const bool away = words_.accept("away");  // "put the plate away in the cabinet"
  if (!words_.comes("either") && !words_.complement_comes()) words_.fail("expected a place, such as 'on a table'");
  placed(clause);
  for (const Complement& complement : clause.complements)
    if (complement.object.empty() || complement.negated || (away && complement.predicate != P::Inside))
      words_.fail("expected a place before this");
  // "Each of the mugs in a cabinet", "both mugs in a cabinet or on a shelf": not all in the same one.
  if ((each || (both && clause.any_complement)) && !words_.failed())
    for (Complement& complement : clause.complements) {
      NounPhrase& place = complement.object[0];
      const bool one = place.determiner == Determiner::New || place.determiner == Determiner::The;
      if (one && place.modifiers.empty()) place.determiner = Determiner::Any;
    }
  return clause;
}

/// "bring me the mug", "dust the desk"
Clause ClauseReader::with_state(Predicate predicate, bool negated, std::string symbol) {
  Clause clause;
  words_.set_bare_places(true);
  clause.subjects = words_.phrases(clause.any_subject);
  words_.set_bare_places(false);
  clause.complements.push_back({predicate, negated, std::move(symbol), {}});
  return clause;
}

/// "move a mug from the desk to the shelf": on or in these, whichever is possible.
Clause ClauseReader::moved_to() {
  Clause clause;
  words_.set_results(true);
  clause.subjects = words_.phrases(clause.any_subject);
  words_.set_results(false);
  if (words_.accept("from")) {
    Complement from{words_.choose(2) == 0 ? P::On : P::Inside, false, "", {words_.phrase()}};
    if (is_room(from.object[0].noun)) from.predicate = P::InRoom;
    if (clause.subjects.size() > 1) words_.fail("expected one object before 'from'");
    clause.subjects[0].modifiers.push_back(std::move(from));
  }
  if (!goes_to(clause)) words_.fail("expected 'to'");
  return clause;
}

/// "to the kitchen", "to the shelf", "onto the table"
bool ClauseReader::goes_to(Clause& clause) {
  const int where = words_.accept_one({"onto", "into", "to"});
  if (where < 0) return false;
  words_.set_bare_rooms(true);
  Complement place{where == 0 ? P::On : P::Inside, false, "", {words_.place()}};
  words_.set_bare_rooms(false);
  if (is_room(place.object[0].noun)) {
    place.predicate = P::InRoom;
  } else if (where == 2 && words_.choose(2) == 0) {
    place.predicate = P::On;
  }
  clause.complements.push_back(std::move(place));
  words_.set_put_last(clause);
  return true;
}

/// "on the table in the kitchen": where something is put.
void ClauseReader::placed(Clause& clause) {
  words_.set_bare_rooms(true);
  words_.complements(clause);
  words_.set_bare_rooms(false);
  words_.set_put_last(clause);
}

/// "take every mug off the table" leaves none; "take a mug to the kitchen" brings one.
Clause ClauseReader::taken() {
  Clause clause;
  clause.subjects = words_.phrases(clause.any_subject);
  if (words_.accept_one({"and put it", "and place it", "and put them"}) >= 0) {
    if (clause.subjects.size() > 1) words_.fail("expected one object before 'and put it'");
    placed(clause);
    return clause;
  }
  if (words_.accept_one({"and bring it", "and bring them"}) >=
      0) {  // "get something to read and bring it to the office"
    if (clause.subjects.size() > 1) words_.fail("expected one object before 'and bring it'");
    if (!goes_to(clause)) words_.fail("expected 'to'");
    return clause;
  }
  if (words_.accept("to me")) {  // "wash the mug and bring it to me"
    clause.complements.push_back({P::Held, false, "", {}});
    return clause;
  }
  if (taken_from(clause)) return clause;
  if (goes_to(clause)) return clause;
  const bool inside = words_.accept("out of");
  if (!inside && words_.accept_one({"off", "from"}) < 0) words_.fail("expected 'to', 'off' or 'out of'");
  clause.removal = true;
  for (NounPhrase& subject : clause.subjects) {
    if (subject.determiner != Determiner::Every) words_.fail("expected 'every …' before this");
    subject.determiner = Determiner::No;
  }
  clause.complements.push_back({inside ? P::Inside : P::On, false, "", {}});
  auto floor = inside ? std::nullopt : words_.room_floor();
  if (floor || (!inside && words_.accept("the floor of"))) clause.complements[0].predicate = P::OnFloor;
  clause.complements[0].object.push_back(floor ? *std::move(floor) : words_.place());
  if (clause.complements[0].object[0].determiner == Determiner::New)
    words_.fail("expected 'one …' or 'any …' before this");
  clause.put_down = put_down();
  return clause;
}

bool ClauseReader::is_room(const Domain& noun) const {
  return noun.kind == Domain::Kind::Room || (!noun.members.empty() && lexicon_.is_room_type(noun.members[0].category));
}

Clause ClauseReader::with_symbol(Predicate predicate) {
  Clause clause;
  words_.set_bare_places(true);
  clause.subjects = words_.phrases(clause.any_subject);
  words_.set_bare_places(false);
  words_.expect("with");
  clause.complements.push_back({predicate, false, words_.symbol(), {}});
  words_.exception(clause);
  return clause;
}

Clause ClauseReader::symbol_first(Predicate predicate, std::string_view link, bool negated) {
  Clause clause;
  clause.complements.push_back({predicate, negated, words_.symbol(), {}});
  if (!negated || !words_.accept("from")) words_.expect(link);  // "wipe the jam from the table"
  words_.set_bare_places(true);
  clause.subjects = words_.phrases(clause.any_subject);
  words_.set_bare_places(false);
  return clause;
}

Clause ClauseReader::changed() {
  Clause clause;
  for (const bool on : {true, false}) {  // "turn the lamp on"
    const std::size_t here = words_.position();
    if (words_.accept_one({"turn", "switch"}) < 0) break;
    if (words_.phrase_comes()) {
      clause.subjects = words_.phrases(clause.any_subject);
      const int which = words_.accept_one({"on", "off"});
      if (which < 0) words_.fail("expected 'on' or 'off'");
      clause.complements.push_back({which == 0 ? P::PowerOn : P::PowerOff, false, "", {}});
      words_.exception(clause);
      return clause;
    }
    words_.go_back(here);
    if (!on) break;
  }
  for (const PredicatePhrase& verb : verb_phrases()) {
    if (!words_.accept(verb.words)) continue;
    words_.set_bare_places(verb.after.empty());
    clause.subjects = words_.phrases(clause.any_subject);
    words_.set_bare_places(false);
    if (!verb.after.empty() && !words_.accept(verb.after) && !verb.optional)
      words_.fail("expected '" + std::string(verb.after) + "'");
    if (verb.predicate == P::Frozen) words_.accept("solid");
    if (verb.predicate == P::Cooked) words_.accept("through");
    for (const NounPhrase& subject : clause.subjects)
      if (subject.determiner == Determiner::No || subject.determiner == Determiner::AtMost)
        words_.fail("expected something to act on before this");
    clause.complements.push_back({verb.predicate, false, "", {}});
    return clause;
  }
  words_.fail("expected what to do, such as 'put' or 'open'");
  return clause;
}

}  // namespace unietp
