#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "annotator/clause.h"
#include "annotator/noun_table.h"
#include "annotator/word_choices.h"
#include "core/result.h"
#include "core/text.h"

namespace unietp {

/// Reads noun phrases and predicates, left to right, at a cursor over the words of a text. Its tables of English are
/// independent of the writer's. The first word that does not fit is the error.
class PhraseReader {
 public:
  /// `choices`: of what words mean that mean several things. All live as long as this.
  PhraseReader(const std::vector<Token>& tokens, const NounTable& lexicon, WordChoices& choices)
      : tokens_(tokens), lexicon_(lexicon), choices_(choices) {}

  bool failed() const { return error_.has_value(); }  // whether some word was not as expected
  const Error& error() const { return *error_; }      // of one that failed
  void fail(const std::string& expected);             // keeps the first, with its column

  bool done() const { return at_ >= tokens_.size(); }    // at the end of the text
  const std::string& peek(std::size_t ahead = 0) const;  // the word that comes after `ahead` others; "" at the end
  int column() const { return done() ? end_column() : tokens_[at_].column; }  // of the next word, from 1
  /// Consumes the words if they come next.
  bool accept(std::string_view words);
  /// Whether the words come next.
  bool comes(std::string_view words) const;
  /// Whether the words come later in the sentence.
  bool follows(std::string_view words) const;
  /// Consumes one of these and returns its index; -1 when none comes next.
  int accept_one(std::initializer_list<std::string_view> choices);
  /// Consumes the words; fails if they do not come next.
  void expect(std::string_view words);
  std::size_t position() const { return at_; }
  void go_back(std::size_t position) { at_ = position; }

  bool phrase_comes() const;  // whether the next words begin a noun phrase
  NounPhrase phrase();        // reads one; fails where there is none
  /// The same of a place: "the desks" are any of them.
  NounPhrase place();
  /// "one of the slices" or "a slice of it", after what it is cut from.
  bool slice_of_it(NounPhrase& phrase);
  /// A bare plural noun, or a singular one.
  NounPhrase bare_noun(bool plural = true);
  /// Things of the kind that was named last.
  NounPhrase last_noun();
  /// "both", followed by a place, of the two things that were named: these; false, with nothing read, when none comes.
  bool both_again(std::vector<NounPhrase>& phrases);
  /// "except for the red one", after all else of a command to every such thing.
  void exception(Clause& clause);
  /// Things of the kind that was put somewhere last: "don't leave any on the desk".
  NounPhrase last_moved();
  /// "three", "12".
  int number();
  /// "a mug, every bowl and that fork"; `any` becomes true for "or".
  std::vector<NounPhrase> phrases(bool& any);
  bool complement_comes() const;
  Complement complement();
  /// What `need`, "something to make it with", and "what I need for that" mean from here on.
  void set_occasion(const Domain& needed, const std::string& need) { occasion_ = needed, need_ = lower(need); }
  /// "Another" alone is of this kind from here on.
  void set_moved(const Domain& moved) { moved_ = moved; }
  /// Where "there, too" is after this command.
  void set_put_last(const Clause& clause);
  /// From here on what is put somewhere may say what is to be done to it: "put a heated egg on a plate".
  void set_results(bool results) { results_ = results; }
  /// One of `count` meanings of the words.
  std::size_t choose(std::size_t count) { return choices_.choose(count); }
  /// From here on a place after a noun describes it: "open the drawer in the kitchen".
  void set_bare_places(bool bare) { bare_places_ = bare; }
  /// The same of rooms alone: "put a mug on the table in the kitchen".
  void set_bare_rooms(bool bare) { bare_rooms_ = bare; }
  /// Whether a comma alone goes on with what is said of something; "before you put it there, open a fridge" does not.
  void set_comma_lists(bool lists) { comma_lists_ = lists; }
  std::optional<NounPhrase> room_floor();
  /// "…, not the blue one": what was told from what is meant since the last call.
  std::vector<NounPhrase> contrasts() { return std::exchange(contrasts_, {}); }
  /// "clean and on that table", "either in a box or on a table"
  void complements(Clause& into);
  /// Words up to where a clause can continue, joined by "_": "tomato_sauce".
  std::string symbol();

 private:
  int end_column() const {
    return tokens_.empty() ? 1 : tokens_.back().column + static_cast<int>(tokens_.back().text.size());
  }
  bool phrase_without_noun(NounPhrase& phrase);
  std::optional<NounPhrase> single_phrase(NounPhrase phrase);
  std::optional<NounPhrase> referring_phrase(NounPhrase phrase);
  std::optional<NounPhrase> quantified_phrase(NounPhrase phrase);
  std::optional<NounPhrase> counted_phrase(NounPhrase phrase);
  NounPhrase noun_with(NounPhrase phrase, Determiner determiner, bool plural = false);
  NounPhrase noun_after(NounPhrase phrase, bool plural);
  NounPhrase described(NounPhrase phrase);
  void description(NounPhrase& phrase);
  bool needed_for_occasion(NounPhrase& phrase);
  bool room_before_noun(NounPhrase& phrase);
  bool one_again(NounPhrase& phrase);
  void left_out(NounPhrase& phrase);
  void direct_description(NounPhrase& phrase);
  void contrast(const NounPhrase& phrase);
  bool result(NounPhrase& phrase);
  void with_something(NounPhrase& phrase);
  bool room_comes() const;
  std::optional<Complement> adjective() const;
  std::optional<Predicate> preposition();
  std::optional<Predicate> on_or_off() const;
  Complement relation(Predicate predicate);

  const std::vector<Token>& tokens_;
  const NounTable& lexicon_;
  WordChoices& choices_;
  std::optional<Domain> occasion_, moved_;
  std::optional<Complement> put_last_;  // where "there, too" is
  std::string need_;                    // of the occasion
  std::vector<Domain> named_;           // what "the red one" may be one of
  std::vector<NounPhrase> contrasts_;
  int depth_ = 0;  // of descriptions, whose nouns it cannot be
  std::size_t at_ = 0;
  bool bare_places_ = false, bare_rooms_ = false, comma_lists_ = true, results_ = false;
  std::optional<Error> error_;
};

}  // namespace unietp
