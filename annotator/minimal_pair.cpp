#include "annotator/minimal_pair.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

#include "annotator/home_facts.h"
#include "annotator/instruction.h"
#include "core/text.h"
#include "logic/evaluate.h"
#include "scene/trace.h"

namespace unietp {
namespace {

constexpr std::size_t kTried = 24;

using WordPair = std::pair<std::string_view, std::string_view>;
constexpr std::array kOpposites{WordPair{"open", "close"},  WordPair{"on", "off"},         WordPair{"on", "in"},
                                WordPair{"heat", "chill"},  WordPair{"two", "three"},      WordPair{"three", "four"},
                                WordPair{"one", "two"},     WordPair{"larger", "smaller"}, WordPair{"dirty", "clean"},
                                WordPair{"open", "closed"}, WordPair{"hot", "cold"},       WordPair{"cooked", "raw"},
                                WordPair{"wash", "soak"},   WordPair{"heated", "chilled"}, WordPair{"washed", "heated"},
                                WordPair{"under", "on"}};

/// A word of the text, and what stands in its place. `alike`: it is said of the same things, as opposites and colors
/// are, and the names of things of one kind.
struct Change {
  std::size_t token = 0;
  std::string word;
  bool alike = true;
};

/// Whether two categories are of one narrowest kind, or of kinds that have the next wider one in common: not just any
/// two things that can be carried.
bool are_alike(const Category* one, const Category* other) {
  constexpr std::array<std::string_view, 4> kAny{"thing", "movable", "place", "fixture"};
  if (one == nullptr || other == nullptr) return false;
  for (std::size_t i = 0; i < std::min<std::size_t>(2, one->kinds.size()); ++i) {
    const std::string& kind = one->kinds[i];
    if (std::find(kAny.begin(), kAny.end(), kind) == kAny.end() &&
        std::find(other->kinds.begin(), other->kinds.end(), kind) != other->kinds.end())
      return true;
  }
  return false;
}

/// Other things of the home that are called by one word, as the one that is named at a token is.
void other_things(const std::vector<Token>& tokens, std::size_t at, const Knowledge& knowledge, const NounTable& nouns,
                  const std::vector<std::string>& there, std::vector<Change>& changes) {
  const auto noun = nouns.noun_at(tokens, at);
  if (noun.length != 1 || noun.nouns.size() != 1 || noun.nouns[0].members.size() != 1) return;
  const std::string& meant = noun.nouns[0].members[0].category;
  const NounTable::Name* own = nouns.display(meant);
  if (own == nullptr) return;
  // "The cabinet where the mug is kept" is not where another mug goes.
  const auto is_said = [&](const std::string& word) {
    return std::any_of(tokens.begin(), tokens.end(), [&](const Token& token) { return token.text == word; });
  };
  for (const std::string& category : there) {
    const NounTable::Name* name = nouns.display(category);
    if (name == nullptr || name == own || name->movable != own->movable || name->countable != own->countable) continue;
    const std::string& word =
        tokens[at].text == own->plural && own->plural != own->singular ? name->plural : name->singular;
    if (word.find(' ') == word.npos && !is_said(lower(word)))
      changes.push_back({at, word, are_alike(knowledge.find(meant), knowledge.find(category))});
  }
}

std::vector<Change> changes_of(const std::vector<Token>& tokens, const Knowledge& knowledge, const NounTable& nouns,
                               const Scene& home) {
  const auto there = categories_in(home);
  std::vector<std::string> colors;
  for (const Node& node : home.nodes)
    if (nouns.is_color(node.color)) colors.push_back(node.color);
  std::vector<Change> changes;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const std::string& word = tokens[i].text;
    for (const auto& [one, other] : kOpposites) {
      if (word == one) changes.push_back({i, std::string(other)});
      if (word == other) changes.push_back({i, std::string(one)});
    }
    for (const std::string& color : colors)
      if (nouns.is_color(word) && word != color) changes.push_back({i, color});
    other_things(tokens, i, knowledge, nouns, there, changes);
  }
  return changes;
}

std::string changed(const std::string& text, const Token& token, std::string word) {
  const auto at = static_cast<std::size_t>(token.column) - 1;
  const bool begins = at == 0 || (at > 1 && (text[at - 2] == '.' || text[at - 2] == '?'));
  if (begins && std::isupper(static_cast<unsigned char>(text[at])) != 0)
    word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
  return text.substr(0, at) + word + text.substr(at + token.text.size());
}

/// "A mug" and "an apple" differ in two words.
bool keeps_article(const std::vector<Token>& tokens, const Change& change) {
  if (change.token == 0) return true;
  const std::string& article = tokens[change.token - 1].text;
  return (article != "a" && article != "an") || with_article(change.word).starts_with(article + " ");
}

}  // namespace

std::optional<MinimalPair> minimal_pair(const std::string& text, const Specification& specification,
                                        const Knowledge& knowledge, const NounTable& nouns, const Scene& home,
                                        Rng rng) {
  const auto tokens = tokens_of(text);
  auto changes = changes_of(tokens, knowledge, nouns, home);
  rng.shuffle(changes);
  std::stable_partition(changes.begin(), changes.end(), [](const Change& change) { return change.alike; });
  if (changes.size() > kTried) changes.resize(kTried);
  const auto says = [&](const std::string& words, const Formula& goal) {
    Specification asked = specification;
    asked.goal = goal;
    return check_instruction(words, asked, knowledge, nouns, &home).empty();
  };
  for (const Change& change : changes) {
    if (!keeps_article(tokens, change)) continue;
    std::string other = changed(text, tokens[change.token], change.word);
    auto goal = goal_of_text(other, specification, knowledge, nouns, home);
    if (!goal || holds(*goal, to_logic(home, {}, reads_comparisons(*goal)))) continue;
    if (!says(other, *goal) || says(other, specification.goal) || says(text, *goal)) continue;
    return MinimalPair{std::move(other), std::move(*goal)};
  }
  return std::nullopt;
}

}  // namespace unietp
