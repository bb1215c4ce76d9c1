#include <algorithm>

#include "generator/consistency.h"
#include "generator/goal_variable.h"
#include "generator/phrase_kind.h"
#include "generator/refinement.h"
#include "sense/place_uses.h"

namespace unietp {
namespace {

Specification substituted(const Specification& plain, const std::string& category,
                          const std::vector<std::string>& values) {
  auto changed = plain;
  changed.goal = substitute_names(plain.goal, {{category, values}});
  for (auto& start : changed.init) start = substitute_names(start, {{category, values}});
  return changed;
}

/// The state that a goal of one object and one state at the end asks for.
std::optional<Predicate> only_state(const Formula& goal) {
  using Op = Formula::Op;
  if (goal.op != Op::Exists || goal.children[0].op != Op::AtEnd) return std::nullopt;
  const Formula& asked = goal.children[0].children[0];
  if (asked.op != Op::Atom || asked.terms.size() != 1) return std::nullopt;
  return asked.predicate;
}

/// Whether the goal names another thing of the same kind: "the butter knife and a utensil to eat with".
bool is_like_another_part(const std::string& serving, const std::string& category, const Specification& plain,
                          const Knowledge& knowledge) {
  const auto* known = knowledge.find(serving);
  return known != nullptr && !known->kinds.empty() &&
         std::any_of(plain.binding.begin(), plain.binding.end(), [&](const auto& pair) {
           const auto* other = pair.second == category ? nullptr : knowledge.find(pair.second);
           return other != nullptr && other->movable && !other->kinds.empty() &&
                  other->kinds.front() == known->kinds.front();
         });
}

/// The categories that a phrase means, of those that could satisfy the goal; none when one of them is another part of
/// the goal, since one word for two parts would be ambiguous, and none when the home has something that the phrase
/// means and that cannot satisfy the goal: a bowl is a dish, too, where bread has to be on a plate. A wider name of
/// which fewer than half the things will do says too much: nobody who can take fruit only asks for a snack.
std::vector<std::string> served_by(const Alias& phrase, const Specification& plain, const std::string& category,
                                   const Knowledge& knowledge, const SceneOffer& offer) {
  std::vector<std::string> serving;
  std::size_t meant = 0;
  for (const auto& alias : knowledge.aliases()) {
    if (alias.kind != phrase.kind || alias.text != phrase.text) continue;
    ++meant;
    if (contradiction(substituted(plain, category, {alias.category}), knowledge)) {
      if (number_of(offer, alias.category) > 0) return {};
      continue;
    }
    const bool other_part =
        alias.category != category && std::any_of(plain.binding.begin(), plain.binding.end(),
                                                  [&](const auto& pair) { return pair.second == alias.category; });
    if (other_part || is_like_another_part(alias.category, category, plain, knowledge)) return {};
    serving.push_back(alias.category);
  }
  if (phrase.kind == AliasKind::Hypernym && 2 * serving.size() < meant) return {};
  std::sort(serving.begin(), serving.end());
  serving.erase(std::unique(serving.begin(), serving.end()), serving.end());
  return serving;
}

/// What each phrase means, for all that mean anything, those first that leave a choice among several categories.
std::vector<std::vector<std::string>> choices_first(const std::vector<const Alias*>& phrases,
                                                    const Specification& plain, const std::string& category,
                                                    const Knowledge& knowledge, const SceneOffer& offer) {
  std::vector<std::vector<std::string>> all;
  for (const Alias* phrase : phrases) all.push_back(served_by(*phrase, plain, category, knowledge, offer));
  std::erase_if(all, [](const auto& serving) { return serving.empty(); });
  std::stable_partition(all.begin(), all.end(), [](const auto& serving) { return serving.size() > 1; });
  return all;
}

/// Whether the goal relates a thing so to something and names a place of that use.
bool goes_to(Predicate relation, PlaceUse use, const GoalVariable& variable, const Specification& plain,
             const Knowledge& knowledge, const PlaceUses* uses) {
  const auto asked = predicates_of(plain.goal, variable.variable);
  if (std::find(asked.begin(), asked.end(), relation) == asked.end()) return false;
  return std::any_of(plain.binding.begin(), plain.binding.end(), [&](const auto& pair) {
    const auto* other = pair.second == variable.category ? nullptr : knowledge.find(pair.second);
    return other != nullptr && uses != nullptr && uses->has(other->kinds, use);
  });
}

/// Whether a thing is put away, washed or thrown away. Who says what they are up to wants what they need for it at
/// hand, not switched off, closed, frozen or beside something else.
bool is_put_away(const GoalVariable& variable, const Specification& plain, const Knowledge& knowledge,
                 const PlaceUses* uses) {
  const auto asked = predicates_of(plain.goal, variable.variable);
  const bool ends_its_use = std::any_of(asked.begin(), asked.end(), [](Predicate predicate) {
    return predicate == Predicate::Frozen || predicate == Predicate::PowerOff || predicate == Predicate::Closed ||
           predicate == Predicate::NextTo;
  });
  if (ends_its_use) return true;
  return goes_to(Predicate::Inside, PlaceUse::NotAtHand, variable, plain, knowledge, uses);
}

/// Whether a thing is got ready, switched on or brought: who says what they are up to does not want what they need for
/// it filled, emptied, heated or cut, nor washed and held on to.
bool is_got_ready(const GoalVariable& variable, const Specification& plain) {
  const auto asked = predicates_of(plain.goal, variable.variable);
  const bool held = std::find(asked.begin(), asked.end(), Predicate::Held) != asked.end();
  if (held && asked.size() > 1) return false;
  return std::all_of(asked.begin(), asked.end(), [](Predicate predicate) {
    return predicate == Predicate::Held || predicate == Predicate::On || predicate == Predicate::InRoom ||
           predicate == Predicate::Inside || predicate == Predicate::OnFloor || predicate == Predicate::Clean ||
           predicate == Predicate::PowerOn;
  });
}

/// Whether people leave open which thing of many kinds is meant: what they want brought, set somewhere for use, or
/// filled. "Turn an electronic device off", "chill a piece of fruit", "put a piece of clothing into the dresser": what
/// is switched, cooked, washed or put away is a certain one.
bool may_be_any_kind(const GoalVariable& variable, const Specification& plain, const Knowledge& knowledge,
                     const PlaceUses* uses) {
  const auto asked = predicates_of(plain.goal, variable.variable);
  return !is_put_away(variable, plain, knowledge, uses) &&
         std::all_of(asked.begin(), asked.end(), [](Predicate predicate) {
           return predicate == Predicate::Held || predicate == Predicate::On || predicate == Predicate::InRoom ||
                  predicate == Predicate::Inside || predicate == Predicate::Filled;
         });
}

/// How many of the goal's categories can be carried. "Wash something to stir it with and the mortar" trips who hears
/// it.
std::ptrdiff_t carried_in(const Formula& goal, const Knowledge& knowledge) {
  const auto categories = categories_of(goal);
  return std::count_if(categories.begin(), categories.end(), [&](const std::string& name) {
    const auto* category = knowledge.find(name);
    return category != nullptr && category->movable;
  });
}

/// Whether a thing may be named by a phrase, for what the goal wants done with it.
bool may_use_phrase(Style style, const GoalVariable& variable, const Specification& plain, const Knowledge& knowledge,
                    const PlaceUses* uses) {
  const auto asked = predicates_of(plain.goal, variable.variable);
  const bool held = std::find(asked.begin(), asked.end(), Predicate::Held) != asked.end();
  if (style == Style::Context) {
    // Who has to write a letter does not want the pen put on the bookcase.
    return is_got_ready(variable, plain) && !is_put_away(variable, plain, knowledge, uses) &&
           !goes_to(Predicate::On, PlaceUse::PutAway, variable, plain, knowledge, uses);
  }
  if (style == Style::Hypernym && held) return false;  // "pick up a piece of clothing"
  const bool any_kind = style == Style::Hypernym || style == Style::Function;
  return !any_kind || may_be_any_kind(variable, plain, knowledge, uses);
}

}  // namespace

bool may_use_phrases(Style style, const Specification& plain, const Knowledge& knowledge, const PlaceUses* uses) {
  if (!names_by_phrase(style)) return true;
  if (style == Style::Context && carried_in(plain.goal, knowledge) > 1) return false;
  const auto variables = singular_variables(plain.goal);
  return std::all_of(variables.begin(), variables.end(), [&](const GoalVariable& variable) {
    const auto* category = knowledge.find(variable.category);
    return category == nullptr || !category->movable || may_use_phrase(style, variable, plain, knowledge, uses);
  });
}

AliasKind phrases_of(Style style) {
  switch (style) {
    case Style::Hypernym:
      return AliasKind::Hypernym;
    case Style::Description:
      return AliasKind::Description;
    case Style::Context:
      return AliasKind::Occasion;
    case Style::Request:
      return AliasKind::Request;
    default:
      return AliasKind::Function;
  }
}

std::optional<Specification> refine_by_phrase(const Specification& plain, const Knowledge& knowledge,
                                              const SceneOffer& offer, Style style, Rng rng) {
  if (style == Style::Context && carried_in(plain.goal, knowledge) > 1) return std::nullopt;
  const bool any_kind = style == Style::Hypernym || style == Style::Function;
  std::vector<std::string> choices;
  for (const auto& variable : singular_variables(plain.goal)) {
    if (!may_use_phrase(style, variable, plain, knowledge, offer.uses)) continue;
    const auto* category = knowledge.find(variable.category);
    if (category != nullptr && (category->movable || style != Style::Function)) choices.push_back(variable.category);
  }
  const auto state = only_state(plain.goal);
  if (style == Style::Request && !state) return std::nullopt;
  rng.shuffle(choices);
  for (const auto& category : choices) {
    auto phrases = knowledge.aliases_of(category, phrases_of(style));
    if (style == Style::Request)
      std::erase_if(phrases,
                    [&](const Alias* alias) { return !alias->text.starts_with(std::string(info(*state).name) + " "); });
    rng.shuffle(phrases);
    for (const auto& serving : choices_first(phrases, plain, category, knowledge, offer)) {
      if (any_kind && serving.size() < 2) break;  // a use that only one kind of thing serves is another name
      auto widened = substituted(plain, category, serving);
      widened.split = Split::Linguistic;
      widened.style = style;
      if (contradiction(widened, knowledge) || bad_start(widened, knowledge, kStartsDrawn)) continue;
      return widened;
    }
  }
  return std::nullopt;
}

}  // namespace unietp
