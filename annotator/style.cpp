#include "annotator/style.h"

#include <algorithm>
#include <array>

#include "annotator/words_for_reading.h"
#include "generator/phrase_kind.h"
#include "scene/states.h"

namespace unietp {
namespace {

using Kind = Requirement::Kind;

bool says_one_thing(const Requirement& requirement) {
  if (requirement.kind != Kind::Final) return false;
  const Clause& clause = requirement.clauses[0];
  return clause.kind == Clause::Kind::Simple && clause.subjects.size() == 1 && clause.complements.size() == 1 &&
         !clause.complements[0].negated && !clause.subjects[0].variable.empty();
}

/// "First … , then …" becomes "…, but … first".
bool make_inverted_order(Message& message) {
  bool turned = false;
  for (Requirement& requirement : message) {
    if (requirement.kind != Kind::Then && requirement.kind != Kind::ThenKept) continue;
    std::swap(requirement.clauses[0], requirement.clauses[1]);
    requirement.inverted = turned = true;
  }
  return turned;
}

/// "Put a mug into the box. Close the box." becomes "Once you've put a mug into the box, close it."
bool make_subordinate_clause(Message& message) {
  for (Requirement& requirement : message) {
    if ((requirement.kind != Kind::Then && requirement.kind != Kind::ThenKept) || requirement.inverted) continue;
    const Clause &sooner = requirement.clauses[0], &later = requirement.clauses[1];
    const auto plain = [](const Clause& clause) {
      return clause.kind == Clause::Kind::Simple && clause.subjects.size() == 1 && clause.complements.size() == 1;
    };
    if (!plain(sooner) || !plain(later)) continue;
    const Complement& put = sooner.complements[0];
    const bool place = put.predicate == Predicate::On || put.predicate == Predicate::Inside;
    if (!place || put.object[0].variable.empty() || later.subjects[0].variable != put.object[0].variable) continue;
    requirement.kind = Kind::Once;
    return true;
  }
  return false;
}

/// A state of what is put somewhere becomes a need: "I'd like a hot potato. Put it on a table."
bool make_need(Message& message) {
  for (std::size_t i = 0; i < message.size(); ++i) {
    if (!says_one_thing(message[i]) || !message[i].clauses[0].complements[0].object.empty()) continue;
    for (std::size_t k = 0; k < message.size(); ++k) {
      if (k == i || !says_one_thing(message[k]) || message[k].clauses[0].complements[0].object.empty()) continue;
      if (message[k].clauses[0].subjects[0].variable != message[i].clauses[0].subjects[0].variable) continue;
      message[i].kind = Kind::Need;
      if (k < i) std::swap(message[i], message[k]);
      return true;
    }
  }
  return false;
}

bool is_at_a_place(const NounPhrase& phrase) {
  return std::any_of(phrase.modifiers.begin(), phrase.modifiers.end(),
                     [](const Complement& modifier) { return !modifier.object.empty(); });
}

NounPhrase* described_phrase(Clause& clause) {
  const auto fits = [](const NounPhrase& phrase) { return !phrase.variable.empty() && !phrase.modifiers.empty(); };
  for (NounPhrase& subject : clause.subjects)
    if (fits(subject)) return &subject;
  for (Complement& complement : clause.complements)
    for (NounPhrase& object : complement.object)
      if (fits(object)) return &object;
  for (Clause& part : clause.parts)
    if (NounPhrase* found = described_phrase(part)) return found;
  return nullptr;
}

/// "There is a mug on the desk.", before the rest. What is only of some color or state nobody would announce.
bool begin_with_fact(Message& message) {
  const NounPhrase* described = nullptr;
  for (Requirement& requirement : message)
    for (Clause& clause : requirement.clauses)
      if (described == nullptr) described = described_phrase(clause);
  if (described == nullptr || !is_at_a_place(*described)) return false;
  Clause so;
  so.subjects.push_back(*described);
  message.insert(message.begin(), {Kind::Fact, {std::move(so)}, false, {}});
  return true;
}

/// "Put every mug that is not red on a table. Keep the red mug …" becomes "Put every mug but the red one on a table."
bool make_exception(Message& message) {
  // One for each place that it is kept from.
  if (std::erase_if(message, [](const Requirement& requirement) { return requirement.kind == Kind::Always; }) == 0)
    return false;
  for (Requirement& requirement : message)
    for (Clause& clause : requirement.clauses)
      for (NounPhrase& subject : clause.subjects) {
        if (subject.determiner != Determiner::Every || subject.modifiers.size() != 1 || !subject.modifiers[0].negated)
          continue;
        subject.modifiers[0].negated = false;
        return subject.except = true;
      }
  return false;
}

/// "If the stove is on, turn it off.": one command about the only such thing, and how that is now.
bool make_condition_of_thing(Plan& plan) {
  if (plan.message.size() != 1 || !says_one_thing(plan.message[0])) return false;
  Clause& clause = plan.message[0].clauses[0];
  const NounPhrase& thing = clause.subjects[0];
  const auto opposite = opposite_of(clause.complements[0].predicate);
  const auto is_so = [&](const NounPhrase& start) {
    return start.noun == thing.noun && start.modifiers.size() == 1 && start.modifiers[0].object.empty() &&
           start.modifiers[0].symbol.empty() && opposite == start.modifiers[0].predicate;
  };
  const auto there = std::find_if(plan.conditions.begin(), plan.conditions.end(), is_so);
  if (!opposite || there == plan.conditions.end() || !thing.modifiers.empty() || thing.there != 1) return false;
  NounPhrase now = *there;
  now.variable = thing.variable;
  clause.given = {std::move(now)};
  return true;
}

/// Makes the whole text one conditional sentence, with a condition that the start meets.
bool make_conditional(Plan& plan) {
  if (plan.conditions.empty()) return false;
  if (make_condition_of_thing(plan)) return true;
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
  std::string_view and_also = {};
};
/// Expressions of a style, of which a text must have one.
constexpr std::array kMarks = {
    Mark{Style::Distractor, "the whole time"},
    Mark{Style::Distractor, "at all times"},
    Mark{Style::Distractor, "leave"},
    Mark{Style::Distractor, "do not open"},
    Mark{Style::Negation, "no"},
    Mark{Style::Negation, "not"},
    Mark{Style::SubordinateClause, "once"},
    Mark{Style::SubordinateClause, "as soon as"},
    Mark{Style::InvertedOrder, ", but", "first"},
    Mark{Style::InvertedOrder, "before you"},
    Mark{Style::Coreference, "where"},
    Mark{Style::Coreference, "on which"},
    Mark{Style::ImplicitNeed, "i'd like"},
    Mark{Style::ImplicitNeed, "i could use"},
    Mark{Style::ImplicitNeed, "i want"},
    Mark{Style::VagueQuantity, "a couple of"},
    Mark{Style::VagueQuantity, "a few"},
    Mark{Style::Condition, "if"},
    Mark{Style::Exception, "but the"},
    Mark{Style::Exception, "except the"},
    Mark{Style::Exception, "except for the"},
    Mark{Style::Ellipsis, "one"},
    Mark{Style::Anaphora, "it"},
    Mark{Style::Anaphora, "that"},
    Mark{Style::Negation, "isn't"},
    Mark{Style::Negation, "don't"},
};

std::string aside_fault(const std::vector<Token>& words, const Formula& goal, const std::vector<std::string>& around,
                        const NounTable& lexicon) {
  const auto own = categories_of(goal);
  for (std::size_t i = 0; i < words.size(); ++i)
    for (const Domain& noun : lexicon.noun_at(words, i).nouns)
      for (const Domain::Member& member : noun.members)
        if (std::find(own.begin(), own.end(), member.category) == own.end() &&
            std::find(around.begin(), around.end(), member.category) != around.end())
          return "";
  return "an aside names something that is in the home and no part of the goal";
}

/// What stands for a thing in a text of a style that names it by a phrase.
std::string phrase_fault(const std::vector<Token>& words, Style style, const NounTable& lexicon) {
  const AliasKind use = phrases_of(style);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto* sentence = lexicon.sentence_at(words, i).first;
    if (sentence != nullptr && sentence->use == use) return "";
  }
  for (const auto& [key, phrase] : lexicon.phrases())
    if (phrase.use == use && (says(words, key) || (!where_of(key).empty() && says(words, where_of(key))))) return "";
  return "the style " + std::string(name_of(style)) + " has a phrase in place of a name, and the text has none";
}

/// "the kitchen cabinet"
std::string compound_fault(const std::vector<Token>& words, const NounTable& lexicon) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto room = lexicon.room_at(words, i);
    if (room.length > 0 && lexicon.noun_at(words, i + room.length).length > 0) return "";
  }
  return "the compound style names a thing after its room, such as 'the kitchen cabinet'";
}

}  // namespace

bool turn_to_style(Plan& plan, Style style) {
  if (style == Style::InvertedOrder) return make_inverted_order(plan.message);
  if (style == Style::SubordinateClause) return make_subordinate_clause(plan.message);
  if (style == Style::ImplicitNeed) return make_need(plan.message);
  if (style == Style::Condition) return make_conditional(plan);
  if (style == Style::Anaphora) return begin_with_fact(plan.message);
  if (style == Style::Exception) return make_exception(plan.message);
  return true;
}

std::string style_fault(const std::string& text, Style style, const Formula& goal,
                        const std::vector<std::string>& around, const NounTable& lexicon) {
  if (style == Style::Direct) return "";
  const std::vector<Token> tokens = tokens_of(text);
  if (names_by_phrase(style)) return phrase_fault(tokens, style, lexicon);
  if (style == Style::Alias) {
    for (const std::string& category : categories_of(goal)) {
      const auto* name = lexicon.display(category);
      if (name == nullptr || lexicon.synonyms(category).empty()) continue;
      if (says(tokens, name->singular) || says(tokens, name->plural))
        return "the alias style calls '" + name->singular + "' by its own name";
    }
    return "";
  }
  if (style == Style::Aside) return aside_fault(tokens, goal, around, lexicon);
  if (style == Style::Compound) return compound_fault(tokens, lexicon);
  const auto of_style = [&](const Mark& mark) { return mark.style == style; };
  const bool marked = std::any_of(kMarks.begin(), kMarks.end(), [&](const Mark& mark) {
    return of_style(mark) && says(tokens, mark.words) && (mark.and_also.empty() || says(tokens, mark.and_also));
  });
  if (marked || std::none_of(kMarks.begin(), kMarks.end(), of_style)) return "";
  const auto first = std::find_if(kMarks.begin(), kMarks.end(), of_style);
  return "a text of the style " + std::string(name_of(style)) + " says '" + std::string(first->words) + "' or the like";
}

}  // namespace unietp
