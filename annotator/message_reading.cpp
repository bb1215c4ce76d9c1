#include "annotator/message_reading.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "annotator/clause_reading.h"
#include "annotator/reading.h"
#include "annotator/reading_proposition.h"
#include "core/text.h"
#include "scene/states.h"

namespace unietp {
namespace {

using Kind = Requirement::Kind;

/// Longer ones first where one begins another.
constexpr std::array<std::string_view, 24> kRequests{
    "could you please", "could you",     "can you please",  "can you",        "would you kindly", "would you",
    "will you please",  "will you",      "i need you to",   "i want you to",  "i'd like you to",  "i would like you to",
    "you need to",      "you should",    "your task is to", "your job is to", "the task is to",   "kindly",
    "please",           "also , please", "also ,",          "also",           "go ahead and",     "you are to"};

constexpr std::array<std::string_view, 4> kClosings{"in the end ,", "at the end ,", "when you are done ,",
                                                    "by the end ,"};

/// What a proposition follows.
constexpr std::array<std::string_view, 6> kExactOpenings{
    "make sure of this :", "see to the following :",   "what counts is this :",
    "the goal is this :",  "what is wanted is this :", "take care of this :"};

class TextReader {
 public:
  TextReader(const std::vector<Token>& tokens, const NounTable& lexicon, WordChoices& choices)
      : tokens_(tokens), lexicon_(lexicon), words_(tokens, lexicon, choices), clauses_(words_, lexicon) {}

  Result<Message> read() {
    while (!words_.done() && !words_.failed()) sentence();
    if (words_.failed()) return words_.error();
    return message_;
  }

 private:
  void end_sentence() {
    contrast();
    words_.accept(", please");
    if (words_.accept_one({".", "?", "!"}) < 0) words_.fail("expected the end of the sentence");
  }

  void say(Kind kind, std::vector<Clause> clauses) { message_.push_back({kind, std::move(clauses), false, {}}); }

  /// A sentence that is known as a whole: an occasion, or a request that names nothing.
  bool known_sentence() {
    const auto [phrase, length] = lexicon_.sentence_at(tokens_, words_.position());
    if (phrase == nullptr) return false;
    words_.go_back(words_.position() + length);
    if (phrase->use == AliasKind::Occasion) {
      words_.set_occasion(phrase->noun, phrase->need);
      return true;
    }
    Clause asked;
    NounPhrase thing;
    thing.noun = phrase->noun;
    thing.by_function = true;
    asked.subjects.push_back(std::move(thing));
    asked.complements.push_back({phrase->state, false, "", {}});
    say(Kind::Final, {std::move(asked)});
    return true;
  }

  /// "There is a dirty mug in the bedroom.", "The lamp in the bedroom is on.", "Never mind the mug on the desk."
  bool fact() {
    Clause so;
    if (words_.accept_one({"never mind", "don't worry about"}) >= 0) {
      words_.set_bare_places(true);
      so.subjects.push_back(words_.phrase());
      words_.set_bare_places(false);
      say(Kind::Fact, {std::move(so)});
      end_sentence();
      return true;
    }
    if (words_.comes("you can leave the") || (words_.comes("the") && words_.follows("can stay where it is"))) {
      const bool leave = words_.accept("you can leave");
      so.subjects.push_back(words_.phrase());
      words_.expect(leave ? "where it is" : "can stay where it is");
      say(Kind::Fact, {std::move(so)});
      end_sentence();
      return true;
    }
    const bool there = words_.accept_one({"there is", "there are", "there's"}) >= 0;
    if (!there && !words_.comes("the")) return false;
    if (there) words_.accept("already");
    if (there && words_.accept("more than one")) {
      so.subjects.push_back(words_.bare_noun(false));
      so.subjects.back().determiner = Determiner::AtLeast;
      so.subjects.back().number = 2;
    } else {
      words_.set_bare_places(!there);
      so.subjects.push_back(words_.phrase());
      words_.set_bare_places(false);
    }
    if (!there && words_.accept_one({"is", "are"}) < 0) words_.fail("expected 'is', or a command such as 'Put …'");
    if (words_.accept_one({"here", "somewhere"}) < 0 && (!there || words_.complement_comes())) words_.complements(so);
    if (so.any_complement) words_.fail("expected what is so, without 'or', before this");
    words_.accept(", but never mind that");
    say(Kind::Fact, {std::move(so)});
    end_sentence();
    return true;
  }

  /// "…, not the blue one": which thing is meant, and that there is another.
  void contrast() {
    std::vector<NounPhrase> others = words_.contrasts();
    if (words_.accept(", not")) others.push_back(words_.phrase());
    for (NounPhrase& other : others) {
      if (other.determiner != Determiner::The || other.modifiers.empty())
        words_.fail("expected which one is not meant, such as 'the blue one', before this");
      Clause so;
      so.subjects.push_back(std::move(other));
      say(Kind::Contrast, {std::move(so)});
    }
  }

  void sentence() {
    clauses_.begin_sentence();
    first_ = message_.size();
    if (known_sentence() || fact()) return;
    for (bool more = true; more;) {
      more = false;
      for (const std::string_view request : kRequests) more |= words_.accept(request);
    }
    for (const std::string_view opening : kExactOpenings)
      if (words_.accept(opening)) {
        message_.push_back({Kind::Stated, {}, false, {read_proposition(words_)}});
        return end_sentence();
      }
    if (words_.accept("if")) return conditional();
    if (words_.accept("choose")) {
      Clause chosen;
      chosen.subjects.push_back(words_.phrase());
      say(Kind::Choose, {chosen});
      return end_sentence();
    }
    for (const std::string_view closing : kClosings)
      if (words_.accept(closing)) {
        say(Kind::Final, {clauses_.statements()});
        return end_sentence();
      }
    if (words_.accept("at some point ,")) {
      say(Kind::Sometime, {clauses_.command()});
      return end_sentence();
    }
    if (words_.accept_one({"i'd like", "i would like", "i could use", "i want", "someone wants", "someone would like",
                           "somebody needs"}) >= 0) {
      say(Kind::Need, {needed()});
      return end_sentence();
    }
    if (words_.accept_one(
            {"once it's in ,", "once they're in ,", "once it's there ,", "once they're there ,", "then"}) >= 0) {
      if (message_.empty() || message_.back().kind != Kind::Final || message_.back().clauses[0].complements.empty())
        return words_.fail("expected what is put somewhere in the sentence before");
      Clause sooner = std::move(message_.back().clauses[0]);
      message_.pop_back();
      say(Kind::Then, {std::move(sooner), clauses_.command()});
      return end_sentence();
    }
    if (words_.accept_one({"once you've", "once you have", "as soon as you've", "as soon as you have"}) >= 0) {
      words_.set_comma_lists(false);
      Clause sooner = clauses_.command();
      words_.set_comma_lists(true);
      words_.expect(",");
      words_.accept("please");
      say(Kind::Then, {std::move(sooner), clauses_.command()});
      return end_sentence();
    }
    if (words_.accept("before you")) {
      words_.set_comma_lists(false);
      Clause later = clauses_.command();
      words_.set_comma_lists(true);
      words_.expect(",");
      words_.accept("please");
      Clause sooner = clauses_.command();
      say(kept() ? Kind::ThenKept : Kind::Then, {std::move(later), std::move(sooner)});
      message_.back().inverted = true;
      return end_sentence();
    }
    if (words_.accept("first")) {
      words_.accept(",");
      in_order();
      return end_sentence();
    }
    commands();
    end_sentence();
  }

  /// "if a fridge is open, close a cabinet"
  void conditional() {
    NounPhrase there = clauses_.condition();
    words_.expect(",");
    words_.accept_one({"please", "then"});
    Clause then = clauses_.command_list();
    if (words_.accept(". if not ,")) return otherwise(std::move(there), std::move(then));
    then.given.push_back(std::move(there));
    say(Kind::Final, {std::move(then)});
    end_sentence();
  }

  /// "If the cabinet is open, put a mug in it. If not, put one on a shelf.": the cabinet is one or the other.
  void otherwise(NounPhrase there, Clause then) {
    words_.expect("put");
    Clause other;
    other.subjects = then.subjects;
    if (words_.accept_one({"it", "them", "one"}) < 0) {
      const NounPhrase again = words_.phrase();
      const bool known = again.determiner == Determiner::The || again.determiner == Determiner::New;
      const bool same =
          known && again.modifiers.empty() && then.subjects.size() == 1 && again.noun == then.subjects[0].noun;
      if (!same) return words_.fail("expected what is put somewhere in the sentence before");
    }
    words_.complements(other);
    const auto& states = there.modifiers;
    const auto opposite = states.size() == 1 && states[0].object.empty() && !states[0].negated
                              ? opposite_of(states[0].predicate)
                              : std::nullopt;
    if (!opposite || then.kind != Clause::Kind::Simple) return words_.fail("expected a state with an opposite before");
    NounPhrase shut = there;
    shut.modifiers[0].predicate = *opposite;
    then.given.push_back(std::move(there));
    other.given.push_back(std::move(shut));
    Clause either;
    either.kind = Clause::Kind::Or;
    either.parts = {std::move(then), std::move(other)};
    say(Kind::Final, {std::move(either)});
    end_sentence();
  }

  /// What is poured out of what the clause before filled is the same.
  static void take_symbol(const Clause& before, Clause& after) {
    if (after.poured && after.complements[0].symbol.empty() && !before.complements.empty())
      after.complements[0].symbol = before.complements[0].symbol;
  }

  /// What follows "then": a command, or another place, "put the egg on the table and then in the sink".
  Clause next(const Clause& before) {
    const bool moved = before.kind == Clause::Kind::Simple && before.subjects.size() == 1 &&
                       before.complements.size() == 1 && before.complements[0].object.size() == 1 &&
                       before.subjects[0].determiner != Determiner::It;
    Clause after;
    if (moved && words_.complement_comes()) {
      NounPhrase thing;
      thing.determiner = Determiner::Known;
      thing.noun = before.subjects[0].noun;
      thing.column = words_.column();
      after.subjects = {std::move(thing)};
      words_.complements(after);
      return after;
    }
    if (moved && words_.phrase_comes() && !words_.comes("it")) {  // "put the egg in the fridge, then the potato"
      after.subjects = {words_.phrase()};
      after.complements = before.complements;
      NounPhrase place;
      place.determiner = Determiner::Known;
      place.noun = before.complements[0].object[0].noun;
      place.column = words_.column();
      after.complements[0].object = {std::move(place)};
      return after;
    }
    after = clauses_.command();
    take_symbol(before, after);
    return after;
  }

  /// "… then …": what follows "first".
  void in_order() {
    Clause before = clauses_.command();
    then();
    Clause after = next(before);
    say(kept() ? Kind::ThenKept : Kind::Then, {std::move(before), std::move(after)});
  }

  bool kept() {
    return words_.accept_one(
               {", and leave both that way", ", with both still so at the end", ", and keep both that way"}) >= 0;
  }

  /// "a hot potato on a table": of what is wanted the adjective is wanted, too.
  Clause needed() {
    Clause clause;
    clause.subjects.push_back(words_.phrase());
    auto& wanted = clause.subjects[0].modifiers;
    if (wanted.size() != 1) words_.fail("expected one state that is wanted, such as 'a hot potato', before this");
    clause.complements = std::move(wanted);
    wanted.clear();
    if (words_.complement_comes()) clause.complements.push_back(words_.complement());
    return clause;
  }

  void then() {
    if (words_.accept_one({", then", "and then", ", and then", ", and after that", "and after that"}) < 0)
      words_.fail("expected 'then'");
  }

  bool then_comes() const { return words_.comes(", then") || words_.comes("and then") || words_.comes(", and then"); }

  void commands() {
    do {
      if (assured() || left_alone()) continue;
      if (words_.accept("keep")) {
        keep();
        continue;
      }
      if (words_.comes("cut a slice of") || words_.comes("cut a piece of")) {  // "… and chill it"
        words_.accept("cut");
        Clause cut;
        cut.subjects.push_back(words_.phrase());
        say(Kind::Choose, {std::move(cut)});
        continue;
      }
      Clause clause = clauses_.command();
      if (clause.put_down && words_.comes(", and") && words_.follows("again")) take_place(clause);
      if (words_.accept(", one for each")) {
        one_for_each(std::move(clause));
        continue;
      }
      if (then_comes()) {
        then();
        Clause after = next(clause);
        const bool again = words_.accept("again");
        say(again ? Kind::Again : kept() ? Kind::ThenKept : Kind::Then, {std::move(clause), std::move(after)});
        return;
      }
      if (words_.accept_one({", and only then", "first , and then"}) >= 0) return only_then(std::move(clause));
      if (words_.accept(", but")) return but_first(std::move(clause));
      say(Kind::Final, {std::move(clause)});
      if (words_.accept("again")) undo();
    } while (!words_.failed() && goes_on());
  }

  /// "take the cup out of the dishwasher, put it somewhere else, and close the dishwasher again": the same one.
  void take_place(Clause& clause) {
    if (clause.complements.size() != 1 || clause.complements[0].object.size() != 1) return;
    NounPhrase& place = clause.complements[0].object[0];
    if (place.determiner != Determiner::The || !place.modifiers.empty()) return;
    Clause named;
    named.subjects.push_back(place);
    say(Kind::Choose, {std::move(named)});
    place.determiner = Determiner::Known;
  }

  /// "put both forks on the table, one for each plate there": as many there as plates.
  void one_for_each(Clause put) {
    Clause counted;
    counted.kind = Clause::Kind::Compare;
    counted.subjects.resize(1);
    counted.subjects[0].noun = put.subjects.front().noun;
    counted.subjects.push_back(words_.bare_noun(false));
    words_.expect("there");
    if (put.complements.size() != 1 || put.complements[0].object.size() != 1)
      return words_.fail("expected one place before 'one for each'");
    NounPhrase place;
    place.determiner = Determiner::Known;
    place.noun = put.complements[0].object[0].noun;
    place.column = words_.column();
    counted.complements.assign(2, put.complements[0]);
    for (Complement& there : counted.complements) there.object = {place};
    say(Kind::Final, {std::move(put)});
    say(Kind::Final, {std::move(counted)});
  }

  /// "Open the oven, but close the dishwasher first."
  void but_first(Clause later) {
    const bool ahead = words_.accept("first");
    say(Kind::Then, {std::move(later), clauses_.command()});
    message_.back().inverted = true;
    if (!ahead) words_.expect("first");
  }

  /// "…, and only then all the mugs": in the same place.
  void only_then(Clause first) {
    Clause late;
    late.subjects.push_back(words_.phrase());
    late.complements = first.complements;
    const bool one_place = late.complements.size() == 1 && late.complements[0].object.size() == 1;
    if (!one_place) return words_.fail("expected one place before 'and only then'");
    NounPhrase place;
    place.determiner = Determiner::Known;
    place.noun = late.complements[0].object[0].noun;
    place.column = words_.column();
    late.complements[0].object = {std::move(place)};
    say(Kind::OnlyThen, {std::move(first), std::move(late)});
  }

  /// "open the fridge, …, and close it again": it is open at some point.
  void undo() {
    const auto state = [](const Requirement& said) {
      const Clause& clause = said.clauses[0];
      const bool simple = said.kind == Kind::Final && clause.complements.size() == 1 && !clause.complements[0].negated;
      return simple && clause.complements[0].object.empty() ? std::optional(clause.complements[0].predicate)
                                                            : std::nullopt;
    };
    const auto last = state(message_.back());
    for (std::size_t i = first_; i + 1 < message_.size() && last; ++i) {
      if (!state(message_[i]) || opposite_of(*state(message_[i])) != *last) continue;
      message_[i].kind = Kind::Sometime;
      return;
    }
    if (last != Predicate::Closed) return words_.fail("expected what is done again to end what was done before");
    Requirement opened{Kind::Sometime, {message_.back().clauses[0]}, false, {}};  // what was taken out of it says so
    opened.clauses[0].complements[0].predicate = Predicate::Open;
    message_.push_back(std::move(opened));
  }

  /// "leave all the plates on the table", "do not open any fridge"
  bool left_alone() {
    Clause clause;
    if (!clauses_.left_alone(clause)) return false;
    words_.accept_one({"the whole time", "at all times"});
    say(Kind::Always, {std::move(clause)});
    return true;
  }

  bool goes_on() {
    if (words_.comes(", please") || words_.comes(", not")) return false;
    const bool comma = words_.accept(",");
    return words_.accept("and") || comma;
  }

  bool assured() {
    if (!clauses_.assurance_comes()) return false;
    if (words_.accept("at some point")) {
      say(Kind::Sometime, {clauses_.statements()});
      return true;
    }
    Clause clause = clauses_.statements();
    if (words_.accept_one({"the whole time", "at all times"}) >= 0) {
      say(Kind::Always, {std::move(clause)});
    } else if (words_.accept("until")) {
      say(Kind::Until, {std::move(clause), clauses_.statements()});
    } else if (words_.accept("before")) {
      say(Kind::Before, {std::move(clause), clauses_.statements()});
    } else {
      say(Kind::Final, {std::move(clause)});
    }
    return true;
  }

  void keep() {
    Clause clause;
    clause.subjects = words_.phrases(clause.any_subject);
    words_.complements(clause);
    if (words_.accept("until")) {
      std::vector<Clause> clauses{std::move(clause), clauses_.statements()};
      const bool then = words_.accept(", then");
      if (then) clauses.push_back(clauses_.command());
      say(then ? Kind::UntilThen : Kind::Until, std::move(clauses));
    } else if (words_.accept_one({"the whole time", "at all times"}) >= 0) {
      say(Kind::Always, {std::move(clause)});
    } else {
      words_.fail("expected 'until' or 'the whole time'");
    }
  }

  const std::vector<Token>& tokens_;
  const NounTable& lexicon_;
  PhraseReader words_;
  ClauseReader clauses_;
  Message message_;
  std::size_t first_ = 0;  // of the sentence
};

}  // namespace

Result<Message> read_message(const std::vector<Token>& tokens, const NounTable& lexicon, WordChoices& choices) {
  return TextReader(tokens, lexicon, choices).read();
}

}  // namespace unietp
