#include "annotator/word_check.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "annotator/goal_words.h"
#include "annotator/naming.h"
#include "annotator/opposite_check.h"
#include "annotator/plain_words.h"
#include "annotator/words_for_reading.h"
#include "core/text.h"
#include "scene/states.h"

namespace unietp {
namespace {

using P = Predicate;
using Tokens = std::vector<Token>;

bool is_number(std::string_view word) {
  return !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isdigit(c); });
}

/// A name of the lexicon in a text.
struct NameInText : NounTable::Reading {
  std::string word;  // itself, if it is a single word
};

/// The words of a text, split into names of the lexicon and other words.
struct ClassifiedWords {
  Tokens plain;
  std::vector<NameInText> nouns;
  std::set<std::string> of_names;  // words that are part of a name
};

/// "can you", "would like": words that are also the name of something.
bool is_helper(const Tokens& words, std::size_t i) {
  const std::string next = i + 1 < words.size() ? words[i + 1].text : "";
  const std::string last = i > 0 ? words[i - 1].text : "";
  if (words[i].text == "can") return next == "you" || next == "i" || next == "stay" || last == "you" || last == "i";
  return false;
}

ClassifiedWords sorted(const Tokens& words, const NounTable& nouns) {
  ClassifiedWords found;
  for (std::size_t i = 0; i < words.size();) {
    const auto where = nouns.where_at(words, i);
    const auto function = where.length > 0 ? where : nouns.function_at(words, i),
               again = nouns.function_again_at(words, i);
    const auto noun = nouns.noun_at(words, i);
    // "A light switch" is no light.
    const bool article = words[i].text == "a" || words[i].text == "an" || words[i].text == "the";
    const std::size_t named = article ? nouns.noun_at(words, i + 1).length + 1 : noun.length;
    const auto& taken = function.length > named ? function : again.length > noun.length ? again : noun;
    if (taken.length == 0 || is_helper(words, i)) {
      found.plain.push_back(words[i++]);
      continue;
    }
    for (std::size_t k = 0; k < taken.length; ++k) found.of_names.insert(words[i + k].text);
    if (taken.length == 1) found.plain.push_back(words[i]);  // "light" is a name and a verb
    found.nouns.push_back({taken, taken.length == 1 ? words[i].text : ""});
    i += taken.length;
  }
  return found;
}

bool any_word(const Tokens& words, std::string_view list) {
  return std::any_of(words.begin(), words.end(), [&](const Token& word) { return is_among(word.text, list); });
}

bool names(const NounTable::Reading& noun, const std::set<std::string>& categories) {
  return std::any_of(noun.nouns.begin(), noun.nouns.end(), [&](const Domain& domain) {
    if (domain.kind != Domain::Kind::Categories) return true;
    return std::any_of(domain.members.begin(), domain.members.end(),
                       [&](const Domain::Member& member) { return categories.contains(member.category); });
  });
}

bool is_named(const std::string& category, const ClassifiedWords& text) {
  return std::any_of(text.nouns.begin(), text.nouns.end(), [&](const auto& noun) { return names(noun, {category}); });
}

bool one_letter_off(std::string_view a, std::string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  if (b.size() - a.size() > 1 || a == b) return false;
  std::size_t i = 0;
  while (i < a.size() && a[i] == b[i]) ++i;
  if (a.size() < b.size()) return a.substr(i) == b.substr(i + 1);
  const bool turned = i + 1 < a.size() && a[i] == b[i + 1] && a[i + 1] == b[i] && a.substr(i + 2) == b.substr(i + 2);
  return turned || a.substr(i + 1) == b.substr(i + 1);
}

std::optional<int> number_of(const std::string& word) {
  for (int i = 2; i <= 12; ++i)
    if (word == number_word(i)) return i;
  if (is_number(word) && word.size() < 5) return std::stoi(word);
  return std::nullopt;
}

class Check {
 public:
  Check(const std::string& text, const Specification& specification, const NounTable& nouns)
      : nouns_(nouns),
        specification_(specification),
        goal_(words_of_goal(specification.goal)),
        words_(tokens_of(replace_all(lower(text), "do not open", "keep closed"))) {
    const auto meant = take_sentences();
    text_ = sorted(words_, nouns);
    text_.nouns.insert(text_.nouns.end(), meant.begin(), meant.end());
  }

  std::vector<std::string> faults() {
    categories();
    symbols();
    if (specification_.style != Style::Request) states();  // which its sentence says
    numbers();
    quantifiers();
    times();
    denials();
    other_words();
    misspelled_names();
    for (std::string& fault : opposite_faults(words_, specification_)) faults_.push_back(std::move(fault));
    return std::move(faults_);
  }

 private:
  /// Takes occasions and requests out of the words, and gives what they mean.
  std::vector<NameInText> take_sentences() {
    std::vector<NameInText> meant;
    for (std::size_t i = 0; i < words_.size();) {
      const auto [phrase, length] = nouns_.sentence_at(words_, i);
      if (phrase == nullptr) {
        ++i;
        continue;
      }
      NameInText name;
      name.length = length;
      name.nouns = {phrase->noun};
      name.singular = true;
      meant.push_back(std::move(name));
      const auto from = words_.begin() + static_cast<std::ptrdiff_t>(i);
      words_.erase(from, from + static_cast<std::ptrdiff_t>(length));
    }
    return meant;
  }

  void lacks(const std::string& what) { faults_.push_back("the text does not say " + what); }
  void exceeds(const std::string& what) { faults_.push_back("the text asks for more than the goal: " + what); }

  void categories() {
    const bool by_function = std::any_of(text_.nouns.begin(), text_.nouns.end(), [](const auto& noun) {
      return !noun.nouns.empty() && noun.nouns.front().members.size() > 1;
    });
    for (const std::string& category : goal_.categories)
      if (!is_named(category, text_) && !by_function) lacks("what '" + shown(category) + "' is about");
    for (const auto& noun : text_.nouns)
      if (!names(noun, goal_.categories) && !allowed_by_style(noun) && !is_said_by(noun) && !is_of_a_symbol(noun))
        exceeds("'" + shown(noun.nouns.front()) + "'");
  }

  /// Whether the style may name it in addition to the goal: something unrelated, or the subject of a condition.
  bool allowed_by_style(const NounTable::Reading& noun) const {
    if (specification_.style == Style::Aside) return true;
    if (specification_.style != Style::Condition) return false;
    std::set<std::string> started;
    for (const Formula& start : specification_.init)
      for (const std::string& category : categories_of(start)) started.insert(category);
    return names(noun, started);
  }

  /// Whether the name is also a word for a predicate of the goal: "on the floor of the kitchen", "switch it on".
  bool is_said_by(const NameInText& noun) const {
    return !noun.word.empty() && std::any_of(goal_.predicates.begin(), goal_.predicates.end(),
                                             [&](P predicate) { return is_among(noun.word, words_for(predicate)); });
  }

  /// Whether the name is a part of a symbol of the goal: "onion powder".
  bool is_of_a_symbol(const NameInText& noun) const {
    return !noun.nouns.empty() && in_a_symbol(replace_all(shown(noun.nouns.front()), " ", "_"));
  }

  std::string shown(const std::string& category) const {
    const auto* name = nouns_.display(category);
    return name == nullptr ? category : name->singular;
  }
  std::string shown(const Domain& domain) const {
    return domain.members.empty() ? to_text(domain) : shown(domain.members.front().category);
  }

  void symbols() {
    for (const std::string& symbol : goal_.symbols) {
      const bool wood = symbol == "wood" && any_word(words_, "wooden. wood.");
      const bool size = symbol == "large" || symbol == "small" || symbol == "any";
      if (!wood && !size && !says(words_, replace_all(symbol, "_", " "))) lacks("'" + symbol + "'");
    }
    for (const Token& word : text_.plain)
      if (nouns_.is_color(word.text) && !in_a_symbol(word.text) && !text_.of_names.contains(word.text))
        exceeds("the colour '" + word.text + "'");
  }

  bool in_a_symbol(const std::string& word) const {
    return std::any_of(goal_.symbols.begin(), goal_.symbols.end(),
                       [&](const std::string& symbol) { return symbol.find(word) != std::string::npos; });
  }

  void states() {
    for (const P predicate : goal_.predicates) {
      const auto list = words_for(predicate);
      if (!list.empty() && !any_word(words_, list) && !is_said_by_if_not(predicate) && !is_said_by_a_name(predicate) &&
          !(predicate == P::Filled && is_watered()))
        lacks("'" + std::string(info(predicate).name) + "'");
    }
    if (specification_.style == Style::Condition) return;  // says states of the start, too
    for (const PredicateInfo& other : all_predicates()) {
      if (goal_.predicates.contains(other.predicate)) continue;
      const auto list = words_only_for(other.predicate);
      const auto word = std::find_if(text_.plain.begin(), text_.plain.end(), [&](const Token& w) {
        return is_among(w.text, list) && !belongs_to_other_predicate(w.text) && !in_a_symbol(w.text);
      });
      if (word != text_.plain.end()) exceeds("'" + word->text + "'");
    }
  }

  /// "water the plant"
  bool is_watered() const {
    for (std::size_t i = 0; i + 1 < words_.size(); ++i)
      if (words_[i].text == "water" && is_among(words_[i + 1].text, "a. an. the. any. every. each. all. both. one."))
        return true;
    return false;
  }

  /// "where we wash our hands", "the kitchen faucet"
  bool is_said_by_a_name(P predicate) const {
    const bool place = predicate == P::On || predicate == P::Inside;
    if (!place && predicate != P::InRoom) return false;
    for (std::size_t i = 0; i < words_.size(); ++i)
      if ((place ? nouns_.where_at(words_, i) : nouns_.room_at(words_, i)).length > 0) return true;
    return false;
  }

  /// "If the box is open, … If not, …": the opposite of a state of the goal that is said.
  bool is_said_by_if_not(P predicate) const {
    const auto opposite = opposite_of(predicate);
    return opposite && says(words_, "if not") && goal_.predicates.contains(*opposite) &&
           any_word(words_, words_for(*opposite));
  }

  /// Whether the word is used for another predicate of the goal: "pour out" for empty, "pour in" for filled.
  bool belongs_to_other_predicate(const std::string& word) const {
    return std::any_of(goal_.predicates.begin(), goal_.predicates.end(),
                       [&](P predicate) { return is_among(word, words_for(predicate)); }) ||
           text_.of_names.contains(word);
  }

  bool start_has(int number) const {
    return std::any_of(specification_.init.begin(), specification_.init.end(),
                       [&](const Formula& f) { return f.op == Formula::Op::Count && f.number == number; });
  }

  void numbers() {
    const auto said = [&](int number) {
      if (number == 2 && (any_word(words_, "couple. pair. both. two. twice.") || says_enough_for_each())) return true;
      if (number == 3 && any_word(words_, "few. three.")) return true;
      return std::any_of(words_.begin(), words_.end(), [&](const Token& w) { return number_of(w.text) == number; });
    };
    for (const int number : goal_.numbers)
      if (!said(number)) lacks("the number " + number_word(number));
    for (const Token& word : text_.plain) {
      const auto number = number_of(word.text);
      const bool of_two = number == 2 && (goal_.predicates.contains(P::Size) || same_twice());
      if (number && !goal_.numbers.contains(*number) && !start_has(*number) && !of_two)
        exceeds("the number " + word.text);
    }
  }

  /// "enough forks, one for each plate there": as many as plates, of which there are several.
  bool says_enough_for_each() const { return says(words_, "enough") && says(words_, "one for each"); }

  /// "two mugs" may also be a mug and another one.
  bool same_twice() const { return to_text(specification_.goal).find("(= ") != std::string::npos; }

  void quantifiers() {
    if (goal_.every && !any_word(words_, "every each all. both. any. everything. none. no. always. whatever others.") &&
        !says(words_, "the other one"))
      lacks("that all are meant ('every', 'all')");
    const bool first_then = goal_.order && says(words_, "first") && says(words_, "then");
    if (goal_.none && !first_then &&
        !any_word(words_,
                  "no. not. none. nothing. never. without. remove take. clear off. out. away. "
                  "empty. nowhere neither any. avoid don't. isn't. aren't. nor. others. only. except. but."))
      lacks("that none is ('no', 'not', 'remove')");
    if (goal_.exactly && !any_word(words_, "exactly precisely just. only. as. equal same. more. evenly.") &&
        !says(words_, "one for each") && !says_number_alone())
      lacks("that the number is exact ('exactly')");
    if (goal_.at_least && !says(words_, "same number of") && !says_enough_for_each() &&
        !any_word(words_, "least. fewer. minimum. more. couple. pair. few. as. or. two. three. evenly."))
      lacks("'at least'");
    if (goal_.at_most && !any_word(words_, "most. more. maximum. up. than. beyond. exceed. only")) lacks("'at most'");
    if (!goal_.every && !goal_.none && any_word(text_.plain, "every. each. everything.") && !at_all_times() &&
        !says(words_, "one on each") && !says(words_, "one for each"))
      exceeds("'every'");
    if (!goal_.exactly && any_word(text_.plain, "exactly. precisely.")) exceeds("'exactly'");
    if (says(words_, "all the") && says(words_, "the other one")) exceeds("'all' beside 'the other one'");
  }

  /// "two mugs", "two bottles of apple juice": without "at least", "up to" or "a couple of".
  bool says_number_alone() const {
    return !goal_.numbers.empty() &&
           !any_word(words_, "least. most. fewer. more. less. minimum. maximum. couple. few.") &&
           !says(words_, "up to");
  }

  bool at_all_times() const { return goal_.throughout && says(words_, "every time"); }

  void times() {
    if (goal_.order &&
        !any_word(words_,
                  "before. first. then. until. till. after. afterwards once. later. only. when. while. prior soon."))
      lacks("the order ('first … then', 'before', 'until')");
    if (goal_.throughout && !any_word(words_,
                                      "always. whole. time. times. throughout. keep never. stay remain leave. "
                                      "ever. moment. all. along. entire while. don't."))
      lacks("that it holds the whole time");
    if (goal_.sometime && !any_word(words_, "some. sometime once. again. then. ever. point. moment. after. first."))
      lacks("that it happens at some point");
    const bool ordered = says(words_, "until") || says(words_, "before you") ||
                         (any_word(words_, "first.") && any_word(words_, "then. after. but."));
    if (ordered && !goal_.order && !goal_.sometime) exceeds("an order");
    if (!goal_.throughout &&
        (says(words_, "the whole time") || any_word(words_, "always. throughout.") || says_never()))
      exceeds("that something holds the whole time");
  }

  /// Whether "never" occurs other than in "never mind".
  bool says_never() const {
    for (std::size_t i = 0; i < words_.size(); ++i)
      if (words_[i].text == "never" && (i + 1 == words_.size() || words_[i + 1].text != "mind")) return true;
    return false;
  }

  /// A denial where the goal has nothing to deny: "do not wash", "never".
  void denials() {
    static const std::set<Style> kDenying{Style::Negation, Style::Distractor, Style::Aside,        Style::Context,
                                          Style::Request,  Style::Condition,  Style::ImplicitNeed, Style::Ellipsis};
    if (kDenying.contains(specification_.style) || denies(specification_.goal) || goal_.order || goal_.throughout)
      return;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      const std::string next = i + 1 < words_.size() ? words_[i + 1].text : "";
      const bool never_mind = words_[i].text == "never" && next == "mind";
      if (i > 0 && words_[i - 1].text == "if" && words_[i].text == "not") continue;
      const bool compares = words_[i].text == "no" && is_among(next, "fewer. less. more. later. longer.");
      if (is_denial(words_[i].text) && !never_mind && !compares && !says_itself(words_[i].text))
        exceeds("'" + words_[i].text + "'");
    }
  }

  static bool denies(const Formula& formula) {
    using Op = Formula::Op;
    const bool bounded = (formula.op == Op::Count || formula.op == Op::CountCompare) &&
                         formula.comparison != Comparison::AtLeast && formula.comparison != Comparison::Greater;
    if (formula.op == Op::Not || formula.op == Op::Forall || bounded) return true;
    if (std::any_of(formula.children.begin(), formula.children.end(), denies)) return true;
    return std::any_of(formula.domain.where.begin(), formula.domain.where.end(), denies);
  }

  /// Words that neither the goal nor the style explains: "throw", "behind", "tomorrow". Styles that tell a story have
  /// words of their own.
  void other_words() {
    static const std::set<Style> kWithStories{Style::Aside, Style::Context, Style::Request, Style::ImplicitNeed};
    if (kWithStories.contains(specification_.style)) return;
    std::set<std::string> told;
    for (const Token& word : text_.plain) {
      const bool letters = std::isalpha(static_cast<unsigned char>(word.text.front())) != 0;
      if (word.text == "into" && says(words_, "into slices")) continue;
      if (word.text == "cut" && says(words_, "cut a") &&
          to_text(specification_.goal).find("/slice") != std::string::npos)
        continue;  // "cut a slice of cake and chill it"
      if (letters && !is_plain_word(word.text) && !says_itself(word.text) && told.insert(word.text).second)
        exceeds("nothing explains '" + word.text + "'");
    }
  }

  /// Whether a word says a state, relation, value or name of the goal, or of the start in a condition.
  bool says_itself(const std::string& word) const {
    const auto says_one_of = [&](const std::set<P>& predicates) {
      return std::any_of(predicates.begin(), predicates.end(),
                         [&](P predicate) { return is_among(word, words_for(predicate)); });
    };
    if (says_one_of(goal_.predicates) || in_a_symbol(word) || text_.of_names.contains(word)) return true;
    if (goal_.symbols.contains("wood") && word == "wooden") return true;
    if (specification_.style != Style::Condition) return false;
    return std::any_of(specification_.init.begin(), specification_.init.end(), [&](const Formula& start) {
      const GoalWords own = words_of_goal(start);
      return says_one_of(own.predicates) ||
             std::any_of(own.symbols.begin(), own.symbols.end(),
                         [&](const std::string& symbol) { return symbol.find(word) != std::string::npos; });
    });
  }

  /// Missing names with a word that differs by one letter. Other misspellings are found by the dictionary (spelling.h).
  void misspelled_names() {
    for (const std::string& category : goal_.categories) {
      const auto* name = nouns_.display(category);
      if (name == nullptr || is_named(category, text_)) continue;
      for (const Token& known : tokens_of(name->singular)) {
        if (known.text.size() < 5) continue;
        for (const Token& word : text_.plain)
          if (one_letter_off(word.text, known.text))
            faults_.push_back("the word '" + word.text + "' looks like a slip for '" + known.text + "'");
      }
    }
  }

  const NounTable& nouns_;
  const Specification& specification_;
  GoalWords goal_;
  Tokens words_;
  ClassifiedWords text_;
  std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> saying_faults(const std::string& text, const Specification& specification,
                                       const NounTable& nouns) {
  return Check(text, specification, nouns).faults();
}

}  // namespace unietp
