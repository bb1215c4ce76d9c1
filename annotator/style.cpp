#include "annotator/style.h"

#include <algorithm>
#include <array>

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
bool invert(Message& message) {
  bool turned = false;
  for (Requirement& requirement : message) {
    if (requirement.kind != Kind::Then && requirement.kind != Kind::ThenKept) continue;
    std::swap(requirement.clauses[0], requirement.clauses[1]);
    requirement.inverted = turned = true;
  }
  return turned;
}

/// "Put a mug into the box. Close the box." becomes "Close the box that you put a mug into."
bool relate(Message& message) {
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

/// A state and a place of one thing become what someone wants.
bool want(Message& message) {
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

struct Mark {
  std::string_view style, words;
};
/// What a text of the style says; one of several suffices.
constexpr std::array kMarks = {
    Mark{"distractor", "the whole time"},
    Mark{"distractor", "at all times"},
    Mark{"negation", "no"},
    Mark{"negation", "not"},
    Mark{"relative-clause", "that you put"},
    Mark{"inverted-order", "before you"},
    Mark{"coreference", "where"},
    Mark{"coreference", "on which"},
    Mark{"implicit-need", "someone wants"},
    Mark{"implicit-need", "someone would like"},
    Mark{"implicit-need", "somebody needs"},
    Mark{"vague-quantity", "a couple of"},
    Mark{"vague-quantity", "a few"},
};

}  // namespace

bool turn_to_style(Plan& plan, std::string_view style) {
  if (style == "inverted-order") return invert(plan.message);
  if (style == "relative-clause") return relate(plan.message);
  if (style == "implicit-need") return want(plan.message);
  return true;
}

std::string style_fault(const std::string& text, std::string_view style, const Formula& goal,
                        const NounTable& lexicon) {
  const std::vector<Token> tokens = tokens_of(text);
  if (style == "function") {
    for (const auto& [phrase, served] : lexicon.function_phrases())
      if (says(tokens, phrase)) return "";
    return "the function style names no object by what it is for";
  }
  if (style == "alias") {
    for (const std::string& category : categories_of(goal)) {
      const auto* name = lexicon.display(category);
      if (name == nullptr || lexicon.synonyms(category).empty()) continue;
      if (says(tokens, name->singular) || says(tokens, name->plural))
        return "the alias style calls '" + name->singular + "' by its own name";
    }
    return "";
  }
  const auto of_style = [&](const Mark& mark) { return mark.style == style; };
  const bool marked = std::any_of(kMarks.begin(), kMarks.end(),
                                  [&](const Mark& mark) { return of_style(mark) && says(tokens, mark.words); });
  if (marked || std::none_of(kMarks.begin(), kMarks.end(), of_style)) return "";
  const auto first = std::find_if(kMarks.begin(), kMarks.end(), of_style);
  return "a text of the style " + std::string(style) + " says '" + std::string(first->words) + "' or the like";
}

}  // namespace unietp
