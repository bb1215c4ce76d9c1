#include "annotator/contrast.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "annotator/words_for_writing.h"
#include "core/sort_unique.h"
#include "scene/states.h"

namespace unietp {
namespace {

using Op = Formula::Op;

void described_in(const Formula& formula, std::vector<const Formula*>& found) {
  if (!formula.domain.where.empty()) found.push_back(&formula);
  for (const Formula& child : formula.children) described_in(child, found);
}

/// Whether the goal asks for a state of the thing. "Empty the red kettle, not the gray one" would forbid to empty both.
bool changes_state(const Formula& formula, const std::string& variable) {
  if (formula.op == Op::Atom) return formula.terms.size() == 1 && formula.terms.front().name == variable;
  return std::any_of(formula.children.begin(), formula.children.end(),
                     [&](const Formula& child) { return changes_state(child, variable); });
}

/// The one thing of a goal that one color, material or state describes, where it is asked to be somewhere.
const Domain* described_thing(const Formula& goal) {
  std::vector<const Formula*> found;
  described_in(goal, found);
  if (found.size() != 1) return nullptr;
  const Domain& thing = found[0]->domain;
  if (thing.members.size() != 1 || thing.members[0].slice) return nullptr;
  const Formula& test = thing.where.front();
  const bool plain = test.op == Op::Atom && (test.terms.size() == 1 || test.terms[1].kind == Term::Kind::Symbol);
  return plain && !changes_state(*found[0], found[0]->variable) ? &thing : nullptr;
}

/// Whether ", not the blue one," may stand before this token: not within a list, and not before "in it".
bool may_interrupt(const std::vector<Token>& tokens, std::size_t thing, std::size_t next) {
  const bool listed = thing > 0 && (tokens[thing - 1].text == "and" || tokens[thing - 1].text == ",");
  const bool short_end = next + 1 < tokens.size() && (tokens[next + 1].text == "it" || tokens[next + 1].text == "them");
  return !listed && !short_end;
}

std::optional<std::string> word_of(const Node& node, const Formula& test, const NounTable& lexicon) {
  if (test.predicate == Predicate::Color)
    return lexicon.is_color(node.color) ? std::optional(node.color) : std::nullopt;
  if (test.predicate == Predicate::Material) {
    if (!lexicon.is_material(node.material)) return std::nullopt;
    return node.material == "wood" ? "wooden" : node.material;
  }
  const auto other = opposite_of(test.predicate);
  if (test.terms.size() > 1 || !other || !node.states.has(*other)) return std::nullopt;
  const std::string word = state_word(*other);
  return word.empty() || word.find(' ') != std::string::npos ? std::nullopt : std::optional(word);
}

/// The word that describes the thing itself.
std::string own_word(const Formula& test) {
  if (test.predicate != Predicate::Color && test.predicate != Predicate::Material) return state_word(test.predicate);
  return test.predicate == Predicate::Material && test.terms[1].name == "wood" ? "wooden" : test.terms[1].name;
}

}  // namespace

std::optional<std::string> contrasted(const std::string& text, const Formula& goal, const Scene& home,
                                      const NounTable& lexicon, Rng& rng) {
  const Domain* thing = described_thing(goal);
  if (thing == nullptr) return std::nullopt;
  const Formula& test = thing->where.front();
  const std::string own = own_word(test);
  std::vector<std::string> words;
  for (const Node& node : home.nodes) {
    if (node.category != thing->members[0].category) continue;
    const auto word = word_of(node, test, lexicon);
    if (word && *word != own) words.push_back(*word);
  }
  sort_unique(words);
  if (words.empty()) return std::nullopt;
  const std::vector<Token> tokens = tokens_of(text);
  for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
    if (tokens[i].text != "the" || tokens[i + 1].text != own) continue;
    const std::size_t length = lexicon.noun_at(tokens, i + 2).length;
    if (length == 0 || i + 2 + length >= tokens.size()) continue;
    const Token& last = tokens[i + 1 + length];
    const auto end = static_cast<std::size_t>(last.column) - 1 + last.text.size();
    const bool goes_on = tokens[i + 2 + length].text != "." && tokens[i + 2 + length].text != "?";
    if (goes_on && !may_interrupt(tokens, i, i + 2 + length)) continue;
    const auto* name = lexicon.display(thing->members[0].category);
    const bool pair = name != nullptr && name->singular.starts_with("pair of ") && tokens[i + 2].text != "pair";
    const bool plural = pair || (name != nullptr && name->singular.ends_with('s') &&
                                 (!name->countable || name->plural == name->singular));
    const std::string other = ", not the " + rng.pick(words) + (plural ? " ones" : " one");
    return text.substr(0, end) + other + (goes_on && text[end] != ',' ? "," : "") + text.substr(end);
  }
  return std::nullopt;
}

}  // namespace unietp
