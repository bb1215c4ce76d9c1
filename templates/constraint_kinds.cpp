#include "templates/constraint_kinds.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

#include "templates/word_meanings.h"

namespace unietp {
namespace {

constexpr auto kKinds = [] {
  using enum ConstraintKind::Meaning;
  using C = ConstraintType;
  using P = Predicate;
  using T = Treatment;
  return std::array<ConstraintKind, 24>{{
      {C::Distinct,
       "distinct",
       Distinct,
       {},
       {},
       "(distinct A B ...)",
       "the placeholders are bound to different categories"},
      {C::FitsOn, "fits-on", Placement, P::On, {}, "(fits-on A B [n])", "at least n A fit on a B at once (default 1)"},
      {C::FitsInside,
       "fits-inside",
       Placement,
       P::Inside,
       {},
       "(fits-inside A B [n])",
       "at least n A fit in a B at once (default 1)"},
      {C::FitsNextTo,
       "fits-next-to",
       Placement,
       P::NextTo,
       {},
       "(fits-next-to A B [n])",
       "at least n A fit next to a B"},
      {C::FitsUnder, "fits-under", Placement, P::Under, {}, "(fits-under A B [n])", "at least n A fit under a B"},
      {C::Heats, "heats", Effect, {}, T::Heats, "(heats T A)", "a T makes an A hot"},
      {C::Cools, "cools", Effect, {}, T::Cools, "(cools T A)", "a T makes an A cool"},
      {C::Freezes, "freezes", Effect, {}, T::Freezes, "(freezes T A)", "a T freezes an A"},
      {C::Washes, "washes", Effect, {}, T::Washes, "(washes T A)", "a T makes an A clean"},
      {C::Wipes, "wipes", Effect, {}, T::Wipes, "(wipes T A)", "an A is wiped clean with a T"},
      {C::Cooks, "cooks", Effect, {}, T::Cooks, "(cooks T A)", "a T cooks an A"},
      {C::Burns, "burns", Effect, {}, T::Burns, "(burns T A)", "a T burns an A"},
      {C::Slices, "slices", Effect, {}, T::Slices, "(slices K A)", "a K cuts an A"},
      {C::Soaks, "soaks", Effect, {}, T::Soaks, "(soaks T A)", "a T soaks an A"},
      {C::Fills, "fills", Effect, {}, T::Fills, "(fills T A substance)", "a T fills an A with the substance"},
      {C::Dispenses,
       "dispenses",
       Effect,
       {},
       T::Dispenses,
       "(dispenses T A substance)",
       "a T spreads the substance over an A"},
      {C::Drains, "drains", Effect, {}, T::Drains, "(drains T A)", "an A is emptied into a T"},
      {C::Attaches, "attaches", Effect, {}, T::Attaches, "(attaches B A)", "an A can be attached to a B"},
      {C::FoundIn, "found-in", Usual, {}, {}, "(found-in A R)", "an A is usual in the room type R"},
      {C::ComesIn,
       "comes-in",
       Value,
       {},
       {},
       "(comes-in A K)",
       "K is a color or material of A, and A has another one that is clearly different"},
      {C::ComesInSizes,
       "comes-in-sizes",
       Sizes,
       {},
       {},
       "(comes-in-sizes A)",
       "one A can be 1.3 times as large as another"},
      {C::HasWords,
       "has-words",
       Words,
       {},
       {},
       "(has-words A synonym|function|occasion)",
       "the knowledge base has such words for an A"},
      {C::Kind,
       "kind",
       OfKind,
       {},
       {},
       "(kind A food ...)",
       "an A is of one of these kinds (data/sense/kinds.csv): (kind A food drink)"},
      {C::SameKind,
       "same-kind",
       SameKind,
       {},
       {},
       "(same-kind A B ...)",
       "these are of a common kind, such as tableware, garments or food; (same-kind A B fruit drink): all are fruit, "
       "or "
       "all are drinks"},
  }};
}();

/// In the order of ParameterWord.
constexpr std::array<WordMeaning, 8> kPseudoAffordances = {{
    {"furniture", "a category that cannot be moved"},
    {"movable", "a category that can be moved"},
    {"countable", "comes in pieces: \"two mugs\", not \"some bread\""},
    {"room", "a room type, such as kitchen; must be the only word"},
    {"colour", "a color, such as red; must be the only word"},
    {"material", "a material, such as wood; must be the only word"},
    {"substance", "what a vessel holds or a bottle dispenses, one word such as dish_soap; must be the only word"},
    {"any", "whatever the constraints allow; must be the only word"},
}};

bool is_number(std::string_view text) {
  int value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  return failure == std::errc{} && end == text.data() + text.size();
}

}  // namespace

std::span<const ConstraintKind> constraint_kinds() { return kKinds; }

const ConstraintKind& info(ConstraintType type) { return kKinds[static_cast<std::size_t>(type)]; }

const ConstraintKind* constraint_kind(std::string_view name) {
  for (const auto& kind : kKinds) {
    if (kind.name == name) return &kind;
  }
  return nullptr;
}

std::string to_text(const DomainConstraint& constraint) {
  std::string text = "(" + std::string(info(constraint.type).name);
  for (const auto& argument : constraint.arguments) text += " " + argument;
  return text + ")";
}

PlaceholderUse placeholder_use(std::string_view argument) {
  constexpr std::string_view kSlice = "/slice";
  if (argument.ends_with(kSlice)) return {std::string(argument.substr(0, argument.size() - kSlice.size())), true};
  return {std::string(argument), false};
}

std::vector<PlaceholderUse> placeholders_of(const DomainConstraint& constraint) {
  using enum ConstraintKind::Meaning;
  const auto meaning = info(constraint.type).meaning;
  std::vector<PlaceholderUse> uses;
  for (std::size_t i = 0; i < constraint.arguments.size(); ++i) {
    const auto& argument = constraint.arguments[i];
    const bool substance =
        meaning == Effect && !argument.empty() && std::isupper(static_cast<unsigned char>(argument.front())) != 0;
    if (meaning != Distinct && meaning != SameKind && i >= 2 && !substance) break;
    if ((meaning == Words || meaning == OfKind) && i >= 1) break;
    if (meaning == SameKind && std::isupper(static_cast<unsigned char>(argument.front())) == 0) break;  // a kind
    uses.push_back(placeholder_use(constraint.arguments[i]));
  }
  return uses;
}

int capacity_of(const DomainConstraint& constraint) {
  if (info(constraint.type).meaning != ConstraintKind::Meaning::Placement || constraint.arguments.size() < 3) return 1;
  const auto& text = constraint.arguments[2];
  int value = 1;
  if (is_number(text)) std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::string substance_of(const DomainConstraint& constraint) {
  if (info(constraint.type).meaning != ConstraintKind::Meaning::Effect || constraint.arguments.size() < 3) return "";
  return constraint.arguments[2];
}

std::optional<ParameterWord> parameter_word(std::string_view word) {
  const auto* found = std::ranges::find(kPseudoAffordances, word, &WordMeaning::word);
  if (found == kPseudoAffordances.end()) return std::nullopt;
  return static_cast<ParameterWord>(found - kPseudoAffordances.begin());
}

bool asks_for(const Parameter& parameter, ParameterWord word) {
  return std::ranges::any_of(parameter.affordances, [word](const auto& one) { return parameter_word(one) == word; });
}

bool is_value(const Parameter& parameter) {
  if (parameter.affordances.size() != 1) return false;
  const auto word = parameter_word(parameter.affordances.front());
  return word == ParameterWord::Color || word == ParameterWord::Material || word == ParameterWord::Substance;
}

bool is_room(const Parameter& parameter) {
  return parameter.affordances.size() == 1 && asks_for(parameter, ParameterWord::Room);
}

const std::vector<std::string>& pseudo_affordances() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names;
    for (const auto& meaning : kPseudoAffordances) names.emplace_back(meaning.word);
    return names;
  }();
  return kNames;
}

std::span<const WordMeaning> pseudo_affordance_meanings() { return kPseudoAffordances; }

}  // namespace unietp
