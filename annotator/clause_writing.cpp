#include "annotator/clause_writing.h"

#include <algorithm>

#include "annotator/idiom_writing.h"
#include "annotator/words_for_writing.h"
#include "core/text.h"

namespace unietp {
namespace {

using Text = std::optional<std::string>;
using P = Predicate;

Place place_of(const Clause& clause) {
  Place place;
  for (const NounPhrase& subject : clause.subjects) {
    place.beside_every |= subject.determiner == Determiner::Every && subject.there != 1;
    place.beside_none |= subject.determiner == Determiner::No;
  }
  for (const Complement& complement : clause.complements) place.beside_none |= complement.negated;
  return place;
}

bool forbids(const NounPhrase& subject) {
  return subject.determiner == Determiner::No || subject.determiner == Determiner::AtMost;
}

/// "No mug has to be there" would forbid none: "no mug may be there".
std::string agreed(const std::string& be, bool plural, bool forbidden = false) {
  if (forbidden && (be == "must be" || be == "has to be")) return "may be";
  if (!plural) return be;
  if (be == "is") return "are";
  return be == "has to be" ? "have to be" : be;
}

bool said_not(const Clause& clause) {
  return clause.complements[0].negated || clause.complements[0].predicate != Predicate::Covered;
}

bool speaks_of(const Clause& clause, const Domain& noun) {
  return any_phrase(clause, [&](const NounPhrase& phrase) { return phrase.noun == noun; });
}

/// Whether an action is done to an object where it stands: "open the drawer in the kitchen" is clear, "cook the egg on
/// a table" is not.
bool is_done_in_place(Predicate predicate) {
  return predicate == P::Open || predicate == P::Closed || predicate == P::PowerOn || predicate == P::PowerOff ||
         predicate == P::Held;
}

/// "Cook the leek next to the knife" is clear, too; "soak the rag in the kitchen" says where to soak it.
bool is_located_by_neighbor(const Clause& clause) {
  const auto& modifiers = clause.subjects[0].modifiers;
  return clause.subjects.size() == 1 && !modifiers.empty() && modifiers.back().predicate == Predicate::NextTo;
}

/// "turn it off" rather than "turn off it"; no long object before "up".
std::string with_particle_order(const std::string& pattern, const std::string& subject, const Complement& said) {
  const auto parted = [](const std::string& words) {
    return words.find(' ') + 1 == words.find("{s}") && !words.ends_with("{s}") && words.find("{o}") == words.npos;
  };
  const bool is_long = std::count(subject.begin(), subject.end(), ' ') > 2;
  for (const std::string& words : verbs(said)) {
    const bool direct = words.find(' ') + 1 == words.find("{s}");
    if (subject == "it" && direct && pattern.find(' ') + 1 != pattern.find("{s}")) return words;
    if (is_long && parted(pattern) && !parted(words)) return words;
  }
  return pattern;
}

/// "take the mug off the desk", "out of the sink": "" where it is described otherwise.
std::string taken_from(const Complement& place) {
  if (place.negated || place.converse || place.object.empty()) return "";
  if (place.predicate == Predicate::On) return " off ";
  if (place.predicate == Predicate::Inside) return " out of ";
  return "";
}

}  // namespace

std::string listed(const std::vector<std::string>& parts, const char* word) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) text += i + 1 < parts.size() ? ", " : std::string(" ") + word + " ";
    text += parts[i];
  }
  return text;
}

std::string ClauseWriter::pick(std::initializer_list<const char*> choices) {
  return *(choices.begin() + rng_.below(choices.size()));
}

/// One of the ways to say it; everyday words take the first of them most often.
const std::string& ClauseWriter::chosen(const std::vector<std::string>& patterns) {
  if (!naming_.everyday()) return patterns[rng_.below(patterns.size())];
  std::size_t at = 0;
  while (at + 1 < patterns.size() && rng_.chance(0.3)) ++at;
  // "Pour water into a can and put it on a table" could be about the water.
  return patterns[at].starts_with("pour ") && !naming_.says_one_thing() ? patterns[0] : patterns[at];
}

/// "keep every fridge closed"
std::optional<std::string> ClauseWriter::keeping(const Clause& clause) {
  if (clause.kind != Clause::Kind::Simple || clause.complements.size() != 1 || clause.any_subject) return std::nullopt;
  if (clause.subjects[0].determiner == Determiner::No || clause.subjects[0].determiner == Determiner::Agent)
    return std::nullopt;
  if (clause.subjects[0].determiner == Determiner::Any) return std::nullopt;
  naming_.begin_clause();
  const auto subjects = subjects_of(clause);
  if (!subjects) return std::nullopt;
  const Text said = naming_.complement(clause.complements[0], place_of(clause));
  return said ? Text("keep " + subjects->text + " " + *said) : std::nullopt;
}

std::optional<Words> ClauseWriter::subjects_of(const Clause& clause, Place place) {
  // "Heat the soup, chill the plum and put both on the table."
  const bool both = naming_.everyday() && place.moved && clause.subjects.size() == 2 && !clause.any_subject &&
                    naming_.named_count() == 2 && clause.subjects[0].noun != clause.subjects[1].noun &&
                    naming_.was_named(clause.subjects[0].variable) && naming_.was_named(clause.subjects[1].variable);
  if (both) return Words{"both", true};
  std::vector<std::string> texts;
  bool plural = clause.subjects.size() > 1 && !clause.any_subject;
  place.beside_the = clause.subjects.size() > 1 &&
                     std::any_of(clause.subjects.begin(), clause.subjects.end(),
                                 [&](const NounPhrase& subject) { return naming_.will_be_the(subject); });
  // "The magazine and the book nearest to the couch": the other way around, it would be nearest to both.
  std::vector<const NounPhrase*> subjects;
  for (const NounPhrase& subject : clause.subjects) subjects.push_back(&subject);
  if (naming_.everyday())
    std::stable_partition(subjects.begin(), subjects.end(), [](const NounPhrase* subject) {
      return subject->modifiers.empty() || subject->modifiers.back().object.empty();
    });
  for (const NounPhrase* subject : subjects) {
    const std::size_t before = naming_.named_count();
    const auto words = naming_.phrase(*subject, place);
    if (!words) return std::nullopt;
    if (clause.any_subject && naming_.named_count() > before) naming_.forget_after(before);
    texts.push_back(words->text);
    plural |= words->plural;
  }
  return Words{listed(texts, clause.any_subject ? "or" : "and"), plural};
}

/// "should not be dusty" rather than "should be not dusty".
std::optional<std::string> ClauseWriter::denial(const Clause& clause, const std::string& be) {
  const auto subjects = subjects_of(clause, {.outcome = true});
  Complement denied = clause.complements[0];
  denied.negated = false;
  const Text said = subjects ? naming_.complement(denied, place_of(clause)) : std::nullopt;
  if (!said) return std::nullopt;
  return subjects->text + (be == "should be" ? " should not be " : " must not be ") + *said;
}

std::optional<std::string> ClauseWriter::statement(const Clause& clause, const std::string& be) {
  naming_.begin_clause();
  if (clause.kind == Clause::Kind::And || clause.kind == Clause::Kind::Or) {
    return joined_parts(clause, &be);
  }
  if (clause.kind == Clause::Kind::Compare) return comparison(clause, be);
  if (be != "is" && clause.complements.size() == 1 && clause.complements[0].negated) return denial(clause, be);
  const auto subjects = subjects_of(clause, {.outcome = true});
  if (!subjects) return std::nullopt;
  std::vector<std::string> parts;
  for (const Complement& complement : clause.complements) {
    const Text said = naming_.complement(complement, place_of(clause));
    if (!said) return std::nullopt;
    parts.push_back(*said);
  }
  const std::string either = clause.any_complement && rng_.chance(0.6) ? "either " : "";
  const bool forbidden = std::all_of(clause.subjects.begin(), clause.subjects.end(), forbids);
  return subjects->text + " " + agreed(be, subjects->plural, forbidden) + " " + either +
         listed(parts, clause.any_complement ? "or" : "and");
}

std::optional<std::string> ClauseWriter::joined_parts(const Clause& clause, const std::string* be) {
  const bool either = clause.kind == Clause::Kind::Or;
  std::vector<std::string> parts;
  for (const Clause& part : clause.parts) {
    if (part.kind == Clause::Kind::Or || (!either && part.kind != Clause::Kind::Simple)) return std::nullopt;
    const std::size_t before = naming_.named_count();
    const Text said = be == nullptr ? command(part) : statement(part, *be);
    const Text condition = said ? given(part) : std::nullopt;
    if (!condition) return std::nullopt;
    if (either) naming_.forget_after(before);
    parts.push_back(*said + *condition);
  }
  return (either ? "either " : "") + listed(parts, either ? "or" : "and");
}

/// " if a fridge is open", or nothing. "Any fridge" where fridges are spoken of: "a fridge" would be the one.
std::optional<std::string> ClauseWriter::given(const Clause& part) {
  std::string text;
  for (const NounPhrase& there : part.given) {
    NounPhrase bare = there;
    bare.modifiers.clear();
    const bool several = speaks_of(part, there.noun) && naming_.is_countable(there.noun);
    if (several && !(naming_.everyday() && naming_.is_alone(there.noun))) bare.determiner = Determiner::Any;
    const auto subject = naming_.phrase(bare, {});
    if (!subject) return std::nullopt;
    std::vector<std::string> states;
    for (const Complement& modifier : there.modifiers) {
      const Text said = naming_.complement(modifier, {});
      if (!said) return std::nullopt;
      // "If the stove is on, …"
      const bool on = naming_.everyday() && there.modifiers.size() == 1 && said->starts_with("switched ");
      states.push_back(on ? said->substr(said->find(' ') + 1) : *said);
    }
    text += (text.empty() ? " if " : " and ") + subject->text + " " + agreed("is", subject->plural) + " " +
            listed(states, "and");
  }
  return text;
}

std::optional<std::string> ClauseWriter::comparison(const Clause& clause, const std::string& be) {
  const auto more = naming_.plural(clause.subjects[0]);
  const Text here = naming_.complement(clause.complements[0], place_of(clause));
  const auto fewer = naming_.plural(clause.subjects[1]);
  const Text there = naming_.complement(clause.complements[1], place_of(clause));
  if (!more || !here || !fewer || !there) return std::nullopt;
  const bool greater = clause.comparison == Comparison::Greater;
  const std::string quantity = greater                                  ? "more "
                               : clause.comparison == Comparison::Equal ? "as many "
                                                                        : "at least as many ";
  const std::string link = greater ? " than " : " as ";
  if (naming_.everyday() && same_place(clause))  // "as many forks as plates on the table"
    return "there " + agreed(be, true) + " " + quantity + *more + link + *fewer + " " + *here;
  const std::string& second = *more == *fewer && rng_.chance(0.5) ? std::string() : *fewer + " ";
  return "there " + agreed(be, true) + " " + quantity + *more + " " + *here + link + second + *there;
}

/// An imperative, without frame.
std::optional<std::string> ClauseWriter::command(const Clause& clause) {
  naming_.begin_clause();
  Text text = worded(clause);
  if (text) naming_.set_topic(clause.subjects.size() == 1 ? clause.subjects[0].variable : "");
  put_last_.reset();
  if (clause.kind != Clause::Kind::Simple || clause.complements.size() != 1) return text;
  const Complement& goes = clause.complements[0];
  if (!goes.negated && (goes.predicate == P::On || goes.predicate == P::Inside)) put_last_ = goes;
  return text;
}

std::optional<std::string> ClauseWriter::there_too(const Complement& goes) const {
  if (!naming_.everyday() || !put_last_ || put_last_->object.empty() || put_last_->predicate != goes.predicate ||
      goes.negated || goes.object[0].variable.empty() || put_last_->object[0].variable != goes.object[0].variable)
    return std::nullopt;
  return goes.predicate == Predicate::Inside ? "in there, too" : "there, too";
}

std::optional<std::string> ClauseWriter::worded(const Clause& clause) {
  if (naming_.everyday() && is_idiom(clause)) return idiom(clause, naming_);
  if (clause.kind == Clause::Kind::And || clause.kind == Clause::Kind::Or) return joined_parts(clause, nullptr);
  if (clause.kind == Clause::Kind::Simple) {
    bool special = false;
    Text text = special_command(clause, special);
    if (special) return text;
    if (clause.complements.size() == 1) {
      auto patterns = naming_.everyday() ? everyday_verbs(clause.complements[0]) : verbs(clause.complements[0]);
      if (naming_.everyday() && !said_not(clause) && naming_.comes_from_a_shaker(clause.complements[0].symbol))
        patterns = {"sprinkle {m} on {s}"};
      if (naming_.everyday() && !said_not(clause) && is_drizzled(clause.complements[0].symbol))
        patterns = {"drizzle {m} over {s}"};
      // One moves an apple to a shelf, and puts it on a plate or in a toaster.
      const auto& places = clause.complements[0].object;
      if (naming_.everyday() && !places.empty() &&
          (naming_.is_carried(places[0].noun) || naming_.heats_food(places[0].noun)))
        std::erase_if(patterns, [](const std::string& pattern) { return pattern.starts_with("move {s} "); });
      // What is kept in a cabinet is put away there; food goes into a fridge.
      if (naming_.everyday() && clause.complements[0].predicate == P::Inside && !clause.complements[0].negated &&
          !places.empty() && naming_.puts_away(places[0].noun) && naming_.is_carried(clause.subjects[0].noun))
        patterns.insert(patterns.begin() + 1, "put {s} away in {o}");
      // "Grab something to wear": what is named by its use is looked for.
      if (naming_.everyday() && naming_.names_by_use(clause.subjects[0].noun) &&
          clause.complements[0].predicate == P::Held)
        patterns = {"grab me {s}"};
      // One fills a glass with water, pours wine and waters plants.
      const Complement& said = clause.complements[0];
      if (naming_.everyday() && said.predicate == P::Filled && !said.negated && said.symbol == "wine" &&
          naming_.says_one_thing())
        patterns = {"pour {m} into {s}"};
      if (naming_.everyday() && said.predicate == P::Filled && !said.negated && said.symbol == "water" &&
          naming_.is_plant(clause.subjects[0].noun))
        patterns = {"water {s}"};
      // One shuts a door or a drawer, and closes a backpack.
      if (naming_.everyday() && said.predicate == P::Closed && naming_.is_carried(clause.subjects[0].noun))
        std::erase(patterns, "shut {s}");
      if (naming_.everyday() && naming_.has_lid(clause.subjects[0].noun))
        for (std::string& pattern : patterns) pattern = replace_all(pattern, "close {s}", "put the lid on {s}");
      // What one holds is washed; a table is cleaned, not washed.
      const Domain& noun = clause.subjects[0].noun;
      const char* unsaid = naming_.is_carried(noun) || naming_.names_by_use(noun) ? "clean {s}" : "wash {s}";
      if (naming_.everyday()) std::erase(patterns, unsaid);
      if (Text cut = naming_.everyday() ? cut_first(clause) : std::nullopt) return cut;
      const bool clean_subject = clause.subjects[0].determiner != Determiner::No &&
                                 clause.subjects[0].determiner != Determiner::AtMost &&
                                 clause.subjects[0].determiner != Determiner::Agent;
      if (!patterns.empty() && clean_subject) return filled(chosen(patterns), clause);
    }
  }
  if (Text left = naming_.everyday() ? no_more(clause, naming_) : std::nullopt) return left;
  const Text stated = statement(clause, "is");
  return stated ? Text("make sure that " + *stated) : std::nullopt;
}

/// "go to the kitchen", "remove every mug from the table", "put every mug either in a box or on a table".
std::optional<std::string> ClauseWriter::special_command(const Clause& clause, bool& special) {
  const Complement& said = clause.complements[0];
  const NounPhrase& subject = clause.subjects[0];
  if (subject.determiner == Determiner::Agent && said.predicate == Predicate::InRoom && !said.negated) {
    special = true;
    const auto room = naming_.phrase(said.object[0], {});
    return room ? Text("go to " + room->text) : std::nullopt;
  }
  const bool single = clause.complements.size() == 1 && clause.subjects.size() == 1 && !said.negated;
  if (single && subject.determiner == Determiner::No && said.predicate == Predicate::Held && rng_.chance(0.7)) {
    special = true;
    NounPhrase any = subject;
    any.determiner = Determiner::Any;
    const auto held = naming_.phrase(any, {});
    return held ? Text("do not hold " + held->text) : std::nullopt;
  }
  const bool place = said.predicate == Predicate::On || said.predicate == Predicate::Inside;
  if (single && subject.determiner == Determiner::No && place && rng_.chance(0.8)) {
    special = true;
    NounPhrase every = subject;
    every.determiner = Determiner::Every;
    const auto taken = naming_.phrase(every, {});
    const auto from = naming_.phrase(said.object[0], {.beside_every = true});
    if (!taken || !from) return std::nullopt;
    if (said.predicate == Predicate::Inside) return "take " + taken->text + " out of " + from->text;
    const bool remove = !naming_.everyday() && rng_.chance(0.6);
    return (remove ? "remove " : "take ") + taken->text + (remove ? " from " : " off ") + from->text;
  }
  if (!clause.any_complement || clause.subjects.size() != 1 || subject.determiner == Determiner::No)
    return std::nullopt;
  for (const Complement& part : clause.complements)
    if (part.negated || (part.predicate != Predicate::On && part.predicate != Predicate::Inside)) return std::nullopt;
  special = true;
  if (naming_.everyday())
    if (Text each = each_somewhere(clause, naming_)) return each;
  const auto moved = naming_.phrase(subject, {});
  if (!moved) return std::nullopt;
  std::vector<std::string> places;
  for (const Complement& part : clause.complements) {
    const Text where = naming_.complement(part, place_of(clause));
    if (!where) return std::nullopt;
    places.push_back(*where);
  }
  return (naming_.everyday() ? "put " : pick({"put ", "place "})) + moved->text + " either " + listed(places, "or");
}

/// "put the mug that is on a desk in a box" could be read as a desk in a box, "put something to toast on a table" as
/// toasting there: "take … and put it in a box" cannot, nor "move the mug from the desk to the shelf".
std::optional<std::string> ClauseWriter::taken_first(const Clause& clause) {
  NounPhrase thing = clause.subjects[0];
  const Complement& goes = clause.complements[0];
  std::string off;
  Text there;
  if (naming_.everyday() && thing.determiner == Determiner::New && !thing.modifiers.empty()) {
    const Complement place = thing.modifiers.back();
    off = taken_from(place);
    if (!off.empty()) {
      thing.modifiers.pop_back();
      // "Take the mug off the desk": where it is, one sees.
      const bool the =
          place.predicate == Predicate::InRoom || (place.predicate == Predicate::On && place.object[0].there > 1);
      const auto here = naming_.phrase(place.object[0], {.inside_description = true, .unique = the});
      if (!here) return std::nullopt;
      there = here->text;
    }
  }
  const auto subject = naming_.phrase(thing, {.unique = there.has_value(), .sought = true});
  if (!subject || (subject->plural && !naming_.everyday())) return std::nullopt;
  Place place = place_of(clause);
  place.bare_room = naming_.everyday();
  const auto again = there_too(goes);
  const bool is_place = goes.predicate == Predicate::On || goes.predicate == Predicate::Inside;
  if (there && !again && is_place && rng_.chance(0.5)) {
    const auto to = naming_.phrase(goes.object[0], place);
    if (!to || to->text == "it") return std::nullopt;
    // "To the toilet" does not say on it.
    const std::string onto = to->text.ends_with("toilet") ? " onto " : " to ";
    const std::string into = goes.predicate == Predicate::Inside ? " into " : onto;
    return "move " + subject->text + " from " + *there + into + to->text;
  }
  const bool sought = naming_.everyday() && naming_.names_by_use(thing.noun);
  // "Get something to read and bring it to the office": nobody puts it in there.
  if (sought && !there && !again && goes.predicate == Predicate::InRoom) {
    const auto room = naming_.phrase(goes.object[0], place);
    if (!room) return std::nullopt;
    return "get " + subject->text + " and bring " + (subject->plural ? "them" : "it") + " to " + room->text;
  }
  const Text where = again ? again : naming_.complement(goes, place);
  const std::string put = naming_.everyday() ? " and put " : pick({" and put ", " and place "});
  return where ? Text((sought ? "get " : "take ") + subject->text + (there ? off + *there : "") + put +
                      (subject->plural ? "them " : "it ") + *where)
               : std::nullopt;
}

bool ClauseWriter::described_by_place(const Clause& clause) const {
  const NounPhrase& subject = clause.subjects[0];
  if (clause.subjects.size() != 1 || clause.complements[0].object.empty()) return false;
  const bool counted = subject.determiner == Determiner::Exactly || subject.determiner == Determiner::AtLeast;
  if (naming_.everyday() && (subject.determiner == Determiner::Every || counted) && !subject.except)
    return !subject.modifiers.empty() && describes_by_place(subject.modifiers.back());
  if (subject.determiner != Determiner::New || naming_.was_named(subject.variable)) return false;
  if (naming_.names_by_use(subject.noun)) return true;
  return !subject.modifiers.empty() && !subject.modifiers.back().object.empty();
}

/// "cut a slice of cake and chill it", of one that is still to be cut.
std::optional<std::string> ClauseWriter::cut_first(const Clause& clause) {
  const NounPhrase& subject = clause.subjects[0];
  const P state = clause.complements[0].predicate;
  const bool slice = subject.noun.members.size() == 1 && subject.noun.members[0].slice;
  if (!slice || clause.subjects.size() != 1 || subject.determiner != Determiner::New || !naming_.says_one_thing() ||
      !subject.modifiers.empty() || !subject.done.empty() || !clause.complements[0].object.empty() ||
      (state != P::Cool && (state != P::Hot || rng_.chance(0.5))))
    return std::nullopt;
  const std::size_t before = naming_.named_count();
  const auto cut = naming_.phrase(subject, {});
  if (cut && (cut->text.starts_with("a slice of ") || cut->text.starts_with("a piece of ")))
    return "cut " + cut->text + (state == P::Cool ? " and chill it" : " and heat it up");
  naming_.forget_after(before);
  return std::nullopt;
}

/// Takes " except for the red one" off the end of what is acted on: where nothing follows it is said last, "put all the
/// mugs on the desk except for the red one". "But the red one" stays beside the thing.
std::string ClauseWriter::taken_exception(const Clause& clause, std::string& subject) {
  const auto at = subject.rfind(" except ");
  if (clause.subjects.size() != 1 || !clause.subjects[0].except || at == std::string::npos) return {};
  std::string exception = subject.substr(at);
  subject.resize(at);
  return exception;
}

std::optional<std::string> ClauseWriter::filled(const std::string& pattern, const Clause& clause) {
  if (described_by_place(clause) && !pattern.starts_with("attach")) return taken_first(clause);
  // Only where the reader expects no place: verbs that end with what they are done to.
  const P state = clause.complements[0].predicate;
  const bool switches = naming_.everyday() && (state == P::PowerOn || state == P::PowerOff);
  const bool bare =
      (pattern.ends_with(" {s}") || switches || pattern.ends_with(" {s} with {m}")) &&
      (is_done_in_place(clause.complements[0].predicate) || (naming_.everyday() && is_located_by_neighbor(clause)));
  const bool moved = pattern.find("{o}") != std::string::npos;
  const bool sought = pattern.starts_with("grab ") || pattern.starts_with("bring ");
  auto subjects = subjects_of(clause, {.bare = bare, .sought = sought, .moved = moved});
  if (!subjects) return std::nullopt;
  if (const auto there = there_too(clause.complements[0])) return "put " + subjects->text + " " + *there;
  std::string exception =
      naming_.everyday() && naming_.says_one_thing() ? taken_exception(clause, subjects->text) : std::string();
  // "Wash a mug and bring it to me": it is in the hand already.
  const bool held = naming_.everyday() && subjects->text == "it" && clause.complements[0].predicate == Predicate::Held;
  std::string text = held ? "bring {s} to me" : with_particle_order(pattern, subjects->text, clause.complements[0]);
  text = replace_all(text, "{m}", symbol_words(clause.complements[0].symbol));
  if (!clause.complements[0].object.empty()) {
    Place place = place_of(clause);
    place.bare_room = naming_.everyday() && text.ends_with(" {o}");
    const auto object = naming_.phrase(clause.complements[0].object[0], place);
    if (!object || (object->text == "it" && text.ends_with(" to {o}"))) return std::nullopt;
    const bool plain = naming_.everyday() && clause.complements[0].object[0].modifiers.empty();
    if (plain || object->text == "it") text = replace_all(text, "the floor of {o}", floor_of(object->text, false));
    text = replace_all(text, "{o}", object->text);
    // "On one of the counters except for the white one" would be of the counters.
    if (!object->text.starts_with("the ")) subjects->text += std::exchange(exception, "");
  }
  if (text.find(" the same ") != std::string::npos)  // not "on the same counter except for the white one"
    return replace_all(text, "{s}", subjects->text + exception);
  return replace_all(text, "{s}", subjects->text) + exception;
}

}  // namespace unietp
