#include "annotator/phenomena.h"

#include <algorithm>
#include <array>

#include "annotator/style.h"
#include "generator/phrase_kind.h"

namespace unietp {
namespace {

/// Those whose marks are words of no other use. "It", "one" and "where" are in many plain texts, and what a sentence is
/// an aside or a distractor to, its words do not tell.
constexpr std::array kMarked{Style::Function,      Style::Hypernym,      Style::Description, Style::Context,
                             Style::Request,       Style::Exception,     Style::Compound,    Style::SubordinateClause,
                             Style::InvertedOrder, Style::VagueQuantity, Style::Condition};

bool is_about(const Domain& noun, const std::vector<std::string>& categories) {
  return std::any_of(noun.members.begin(), noun.members.end(), [&](const Domain::Member& member) {
    return std::find(categories.begin(), categories.end(), member.category) != categories.end();
  });
}

/// "A table" is a kind of thing here and the name of a category there.
bool has_phrase_of(const std::vector<Token>& words, Style style, const std::vector<std::string>& categories,
                   const NounTable& lexicon) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (const auto* sentence = lexicon.sentence_at(words, i).first)
      if (sentence->use == phrases_of(style) && is_about(sentence->noun, categories)) return true;
    const auto where = lexicon.where_at(words, i);
    if (style == Style::Description && where.length > 0 && is_about(where.nouns.front(), categories)) return true;
    const auto phrase = lexicon.function_at(words, i);
    if (phrase.length == 0 || !is_about(phrase.nouns.front(), categories)) continue;
    std::string said;
    for (std::size_t k = 0; k < phrase.length; ++k) said += (k == 0 ? "" : " ") + words[i + k].text;
    const auto found = lexicon.phrases().find(said);
    if (found != lexicon.phrases().end() && found->second.use == phrases_of(style)) return true;
  }
  return false;
}

/// "The cupboard where the sponge is kept": a place by what it is used for.
bool tells_what_is_kept(const std::vector<Token>& words) {
  const auto where = std::find_if(words.begin(), words.end(), [](const Token& word) { return word.text == "where"; });
  return std::any_of(where, words.end(), [](const Token& word) { return word.text == "kept"; });
}

/// Whether some thing of the goal is called by another name, and not by its usual one.
bool has_alias(const std::vector<Token>& words, const std::vector<std::string>& categories, const NounTable& lexicon) {
  return std::any_of(categories.begin(), categories.end(), [&](const std::string& category) {
    const auto* usual = lexicon.display(category);
    if (usual == nullptr || says(words, usual->singular) || says(words, usual->plural)) return false;
    const auto others = lexicon.synonyms(category);
    return std::any_of(others.begin(), others.end(), [&](const NounTable::Name& other) {
      return says(words, other.singular) || says(words, other.plural);
    });
  });
}

/// "Not in the sink", "no mug", and not "no more than two mugs".
bool denies(const std::vector<Token>& words) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i].text;
    if (word == "not" || word == "isn't" || word == "aren't" || word == "don't") return true;
    const std::string next = i + 1 < words.size() ? words[i + 1].text : "";
    if (word == "no" && next != "more" && next != "fewer") return true;
  }
  return false;
}

}  // namespace

std::vector<Style> phenomena_of(const std::string& text, Style style, const Formula& goal, const NounTable& lexicon) {
  const auto words = tokens_of(text);
  const auto categories = categories_of(goal);
  std::vector<Style> shown;
  for (std::size_t i = 0; i < kStyleCount; ++i) {
    const auto one = static_cast<Style>(i);
    const bool marked = std::find(kMarked.begin(), kMarked.end(), one) != kMarked.end();
    const bool seen = one == Style::Negation                                   ? denies(words)
                      : one == Style::Alias                                    ? has_alias(words, categories, lexicon)
                      : one == Style::Description && tells_what_is_kept(words) ? true
                      : !marked                                                ? false
                      : names_by_phrase(one) ? has_phrase_of(words, one, categories, lexicon)
                                             : style_fault(text, one, goal, {}, lexicon).empty();
    if (one != Style::Direct && (one == style || seen)) shown.push_back(one);
  }
  return shown;
}

std::vector<std::string> names_of(const std::vector<Style>& styles) {
  std::vector<std::string> names;
  for (const Style style : styles) names.emplace_back(name_of(style));
  return names;
}

}  // namespace unietp
