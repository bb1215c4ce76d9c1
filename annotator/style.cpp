#include "annotator/style.h"

#include <algorithm>
#include <array>

#include "annotator/words_for_reading.h"

namespace unietp {
namespace {

using Kind = Requirement::Kind;

bool says_one_thing(const Requirement& requirement) {
  if (requirement.kind != Kind::Final) return false;
  const Clause& clause = requirement.clauses[0];
  return clause.kind == Clause::Kind::Simple && clause.subjects.size() == 1 && clause.complements.size() == 1 &&
         !clause.complements[0].negated && !clause.subjects[0].variable.empty();
}

/// First … then becomes before …, … .
bool make_inverted_order(Message& message) {
  bool turned = false;
  for (Requirement& requirement : message) {
    if (requirement.kind != Kind::Then && requirement.kind != Kind::ThenKept) continue;
    std::swap(requirement.clauses[0], requirement.clauses[1]);
    requirement.inverted = turned = true;
  }
  return turned;
}

/// "Put a mug into the box. Close the box." becomes "Close the box that you put a mug into."
bool make_relative_clause(Message& message) {
  for (std::size_t i = 0; i < message.size(); ++i) {
    if (!says_one_thing(message[i])) continue;
    const Complement put = message[i].clauses[0].complements[0];
    const bool place = put.predicate == Predicate::On || put.predicate == Predicate::Inside;
    if (!place || put.object[0].variable.empty()) continue;
    for (std::size_t k = 0; k < message.size(); ++k) {
      if (k == i || !says_one_thing(message[k])) continue;
      NounPhrase& subject = message[k].clauses[0].subjects[0];
      if (subject.variable != put.object[0].variable) continue;
      subject.done.push_back({put.predicate, false, "", {message[i].clauses[0].subjects[0]}, true});
      std::rotate(message.begin(), message.begin() + static_cast<std::ptrdiff_t>(k),
                  message.begin() + static_cast<std::ptrdiff_t>(k) + 1);
      message.erase(message.begin() + static_cast<std::ptrdiff_t>(k < i ? i : i + 1));
      return true;
    }
  }
  return false;
}

/// A state and a place of one object become a need: "someone wants a hot potato on a table".
bool make_need(Message& message) {
  for (std::size_t i = 0; i < message.size(); ++i) {
    if (!says_one_thing(message[i]) || !message[i].clauses[0].complements[0].object.empty()) continue;
    for (std::size_t k = 0; k < message.size(); ++k) {
      if (k == i || !says_one_thing(message[k]) || message[k].clauses[0].complements[0].object.empty()) continue;
      if (message[k].clauses[0].subjects[0].variable != message[i].clauses[0].subjects[0].variable) continue;
      message[i].kind = Kind::Need;
      message[i].clauses[0].complements.push_back(message[k].clauses[0].complements[0]);
      message.erase(message.begin() + static_cast<std::ptrdiff_t>(k));
      return true;
    }
  }
  return false;
}

/// Makes the whole text one conditional sentence, with a condition that the start meets.
bool make_conditional(Plan& plan) {
  if (plan.conditions.empty()) return false;
  Clause all;
  all.kind = Clause::Kind::And;
  for (const Requirement& requirement : plan.message) {
    if (requirement.kind != Kind::Final) return false;
    all.parts.push_back(requirement.clauses[0]);
  }
  Clause said = all.parts.size() == 1 ? all.parts[0] : all;
  said.given = {plan.conditions.front()};
  plan.message = {{Kind::Final, {said}, false, {}}};
  return true;
}

struct Mark {
  Style style;
  std::string_view words;
};
/// Expressions of a style, of which a text must have one.
constexpr std::array kMarks = {
    Mark{Style::Distractor, "the whole time"},
    Mark{Style::Distractor, "at all times"},
    Mark{Style::Negation, "no"},
    Mark{Style::Negation, "not"},
    Mark{Style::RelativeClause, "that you put"},
    Mark{Style::InvertedOrder, "before you"},
    Mark{Style::Coreference, "where"},
    Mark{Style::Coreference, "on which"},
    Mark{Style::ImplicitNeed, "someone wants"},
    Mark{Style::ImplicitNeed, "someone would like"},
    Mark{Style::ImplicitNeed, "somebody needs"},
    Mark{Style::VagueQuantity, "a couple of"},
    Mark{Style::VagueQuantity, "a few"},
    Mark{Style::Condition, "if"},
};

std::vector<std::string> sentences_of(const std::string& text) {
  std::vector<std::string> sentences;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find_first_of(".!?", from), text.size());
    sentences.push_back(text.substr(from, end - from));
    from = end + 1;
  }
  return sentences;
}

/// Number of leading sentences that name no object: two make a background, one a context.
int background_sentences(const std::string& text, const NounTable& lexicon) {
  int idle = 0;
  for (const std::string& sentence : sentences_of(text)) {
    const std::vector<Token> words = tokens_of(sentence);
    bool names = false;
    for (std::size_t i = 0; i < words.size(); ++i) {
      const bool determined = i > 0 && (words[i - 1].text == "a" || words[i - 1].text == "an" ||
                                        words[i - 1].text == "the" || words[i - 1].text == "every");
      names = names || (determined && lexicon.noun_at(words, i).length > 0);
    }
    if (names) break;
    ++idle;
  }
  return idle;
}

std::string bystander_fault(const std::vector<Token>& words, const Formula& goal,
                            const std::vector<std::string>& around, const NounTable& lexicon) {
  const auto own = categories_of(goal);
  for (std::size_t i = 0; i < words.size(); ++i)
    for (const Domain& noun : lexicon.noun_at(words, i).nouns)
      for (const Domain::Member& member : noun.members)
        if (std::find(own.begin(), own.end(), member.category) == own.end() &&
            std::find(around.begin(), around.end(), member.category) != around.end())
          return "";
  return "the bystander style names something that is in the home and no part of the goal";
}

/// One sentence of twenty words or more with two subordinate clauses.
std::string nesting_fault(const std::string& text) {
  constexpr std::string_view kSubordinate =
      "that. which. who. if. as. because. since. where. once. whether. what. when.";
  for (const std::string& sentence : sentences_of(text)) {
    const std::vector<Token> words = tokens_of(sentence);
    const auto clauses =
        std::count_if(words.begin(), words.end(), [&](const Token& word) { return is_among(word.text, kSubordinate); });
    if (words.size() >= 20 && clauses >= 2) return "";
  }
  return "the nested-syntax style has a sentence of at least twenty words with two subordinate clauses";
}

}  // namespace

bool turn_to_style(Plan& plan, Style style) {
  if (style == Style::InvertedOrder) return make_inverted_order(plan.message);
  if (style == Style::RelativeClause) return make_relative_clause(plan.message);
  if (style == Style::ImplicitNeed) return make_need(plan.message);
  if (style == Style::Condition) return make_conditional(plan);
  return true;
}

std::string style_fault(const std::string& text, Style style, const Formula& goal,
                        const std::vector<std::string>& around, const NounTable& lexicon) {
  if (style == Style::Direct) return "";
  const std::vector<Token> tokens = tokens_of(text);
  if (style == Style::Function) {
    for (const auto& [phrase, served] : lexicon.function_phrases())
      if (says(tokens, phrase)) return "";
    return "the function style names no object by what it is for";
  }
  if (style == Style::Alias) {
    for (const std::string& category : categories_of(goal)) {
      const auto* name = lexicon.display(category);
      if (name == nullptr || lexicon.synonyms(category).empty()) continue;
      if (says(tokens, name->singular) || says(tokens, name->plural))
        return "the alias style calls '" + name->singular + "' by its own name";
    }
    return "";
  }
  if (style == Style::Background && background_sentences(text, lexicon) < 2)
    return "the background style begins with at least two sentences that name no thing";
  const bool known_context = lexicon.behind_context(text).size() < text.size();
  if (style == Style::Context && !known_context && background_sentences(text, lexicon) < 1)
    return "the context style begins with a sentence that gives the occasion and names no thing";
  if (style == Style::Bystander) return bystander_fault(tokens, goal, around, lexicon);
  if (style == Style::NestedSyntax) return nesting_fault(text);
  const auto of_style = [&](const Mark& mark) { return mark.style == style; };
  const bool marked = std::any_of(kMarks.begin(), kMarks.end(),
                                  [&](const Mark& mark) { return of_style(mark) && says(tokens, mark.words); });
  if (marked || std::none_of(kMarks.begin(), kMarks.end(), of_style)) return "";
  const auto first = std::find_if(kMarks.begin(), kMarks.end(), of_style);
  return "a text of the style " + std::string(name_of(style)) + " says '" + std::string(first->words) + "' or the like";
}

}  // namespace unietp
