#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "annotator/clause.h"
#include "annotator/word_choices.h"
#include "core/result.h"

namespace unietp {

/// A noun phrase after resolution: a term, or a quantifier that is still to be put around what is said of it.
struct Resolved {
  Term term;
  bool local = false;  // quantified right around its atom or clause
  Domain domain;
  const NounPhrase* phrase = nullptr;
};

/// The existential variables of a text, or of one alternative of an `or`.
struct Box {
  std::vector<std::pair<std::string, Domain>> variables;
  std::vector<Formula> distinct;
};
/// The body inside existential quantifiers for the box.
Formula boxed(const Box& box, Formula body);

/// The quantifier of a local slot around what is said of it.
Formula quantified(const Resolved& slot, Formula body);
/// What a complement says of the subject; `object` is that of a relation.
Formula said_of(const Complement& complement, const Term& subject, const Resolved* object);

/// Resolves the nouns and pronouns of a text, from left to right. The first ambiguous or unresolved phrase is the
/// error.
class References {
 public:
  /// `choices`: of what "it" means, where several objects were named. Lives as long as this.
  explicit References(WordChoices& choices) : choices_(choices) {}

  const std::optional<Error>& error() const { return error_; }  // the first failure
  void fail(int column, std::string message);                   // keeps the first

  /// `New` phrases are put into the box.
  Resolved resolve(const NounPhrase& phrase, Box& box);
  /// Whether such a thing was named.
  bool is_named(const Domain& noun) const { return !named(noun).empty(); }
  /// Any such object, whatever the article: put around what is said of it.
  Resolved any_of(const NounPhrase& phrase, Box& box);
  /// A new object of the box, whatever the article.
  Resolved introduced(const NounPhrase& phrase, Box& box);
  /// The same of "if a fridge is open, …", whose modifiers are what is said of it.
  Resolved given(const NounPhrase& phrase, Box& box);
  /// The object named before that a phrase means.
  Term known(const NounPhrase& phrase);
  /// Binds a variable by a phrase of any determiner; its name can be referred to until `leave`.
  Resolved bound(const NounPhrase& phrase);

  /// A command or statement begins: its "it" is not what it names itself, as "put a mug in it" shows.
  void begin_clause() { clause_ = mentions_.size(); }
  /// What was named within a description is not what was spoken of last: "switch on the washer that you put a shirt
  /// into" is of the washer.
  void mention_again(const Resolved& slot) { mentions_.push_back(slot.local ? "" : slot.term.name); }
  /// What was named since this many mentions is spoken of no more: "not the blue one".
  std::size_t mention_count() const { return mentions_.size(); }
  void forget_mentions(std::size_t before) { mentions_.resize(before); }
  /// From here on "it" is not clear: "there is a tomato next to the apple".
  void mention_several() { mentions_.emplace_back(); }
  /// What the command so far was about; "" for several things.
  void set_topic(const std::string& variable) { topic_ = variable; }
  /// Whether some "it" was taken for something else than what was named last, or what the last command was about.
  bool is_strained() const { return strained_; }

  std::size_t named_count() const { return referents_.size(); }  // things named so far
  /// What was named since cannot be referred to from here on.
  void leave(std::size_t before);

  /// Of which the text takes the home to have none.
  const std::vector<Domain>& absent() const { return absent_; }

  std::string fresh();  // a variable that no phrase has yet
  /// `text`: where "the kitchen" of "every cabinet in the kitchen" is named; nullptr: within the description.
  Domain restricted(const NounPhrase& phrase, const std::string& name, Box* text = nullptr);

 private:
  WordChoices& choices_;
  struct Referent {
    std::string variable;
    Domain noun;
    bool vague = false;     // "that object" may mean it
    bool definite = false;  // named by "the": there is one only, whoever speaks of it
  };
  std::vector<const Referent*> named(const Domain& noun) const;
  bool hidden(const Domain& noun) const;
  Formula restriction(const Complement& modifier, const Term& subject, Box* text);
  Term pronoun(int column);

  std::vector<Referent> referents_;
  std::vector<Domain> hidden_;  // named as one of several, but cannot be referred to
  std::vector<Domain> absent_;
  std::vector<std::string> mentions_;  // variables in order of the text, the latest last; "": what "it" cannot mean
  std::size_t clause_ = 0;             // mentions before the present clause
  std::string topic_;                  // a variable, or ""
  bool strained_ = false;
  int count_ = 0;
  std::optional<Error> error_;
};

}  // namespace unietp
