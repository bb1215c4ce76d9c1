#include "templates/constraint_kinds.h"

#include <array>
#include <cctype>
#include <charconv>

#include "templates/word_meanings.h"

namespace unietp {
namespace {

constexpr auto kKinds = [] {
  using enum ConstraintKind::Meaning;
  using P = Predicate;
  using T = Treatment;
  return std::array<ConstraintKind, 22>{{
      {"distinct", Distinct, {}, {}, "(distinct A B ...)", "the placeholders are bound to different categories"},
      {"fits-on", Placement, P::On, {}, "(fits-on A B [n])", "at least n A fit on a B at once (default 1)"},
      {"fits-inside", Placement, P::Inside, {}, "(fits-inside A B [n])", "at least n A fit in a B at once (default 1)"},
      {"fits-next-to", Placement, P::NextTo, {}, "(fits-next-to A B [n])", "at least n A fit next to a B"},
      {"fits-under", Placement, P::Under, {}, "(fits-under A B [n])", "at least n A fit under a B"},
      {"heats", Effect, {}, T::Heats, "(heats T A)", "a T makes an A hot"},
      {"cools", Effect, {}, T::Cools, "(cools T A)", "a T makes an A cool"},
      {"freezes", Effect, {}, T::Freezes, "(freezes T A)", "a T freezes an A"},
      {"washes", Effect, {}, T::Washes, "(washes T A)", "a T makes an A clean"},
      {"wipes", Effect, {}, T::Wipes, "(wipes T A)", "an A is wiped clean with a T"},
      {"cooks", Effect, {}, T::Cooks, "(cooks T A)", "a T cooks an A"},
      {"burns", Effect, {}, T::Burns, "(burns T A)", "a T burns an A"},
      {"slices", Effect, {}, T::Slices, "(slices K A)", "a K cuts an A"},
      {"soaks", Effect, {}, T::Soaks, "(soaks T A)", "a T soaks an A"},
      {"fills", Effect, {}, T::Fills, "(fills T A substance)", "a T fills an A with the substance"},
      {"dispenses", Effect, {}, T::Dispenses, "(dispenses T A substance)", "a T spreads the substance over an A"},
      {"drains", Effect, {}, T::Drains, "(drains T A)", "an A is emptied into a T"},
      {"attaches", Effect, {}, T::Attaches, "(attaches B A)", "an A can be attached to a B"},
      {"found-in", Usual, {}, {}, "(found-in A R)", "an A is usual in the room type R"},
      {"comes-in",
       Value,
       {},
       {},
       "(comes-in A K)",
       "K is a color or material of A, and A has another one that is clearly different"},
      {"comes-in-sizes", Sizes, {}, {}, "(comes-in-sizes A)", "one A can be 1.3 times as large as another"},
      {"has-words",
       Words,
       {},
       {},
       "(has-words A synonym|function|context)",
       "the knowledge base has such words for an A"},
  }};
}();

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

const ConstraintKind* constraint_kind(std::string_view name) {
  for (const auto& kind : kKinds) {
    if (kind.name == name) return &kind;
  }
  return nullptr;
}

PlaceholderUse placeholder_use(std::string_view argument) {
  constexpr std::string_view kSlice = "/slice";
  if (argument.ends_with(kSlice)) return {std::string(argument.substr(0, argument.size() - kSlice.size())), true};
  return {std::string(argument), false};
}

std::vector<PlaceholderUse> placeholders_of(const DomainConstraint& constraint) {
  const auto* kind = constraint_kind(constraint.kind);
  std::vector<PlaceholderUse> uses;
  for (std::size_t i = 0; i < constraint.arguments.size(); ++i) {
    const auto& argument = constraint.arguments[i];
    const bool substance = kind != nullptr && kind->meaning == ConstraintKind::Meaning::Effect && !argument.empty() &&
                           std::isupper(static_cast<unsigned char>(argument.front())) != 0;
    if (kind != nullptr && kind->meaning != ConstraintKind::Meaning::Distinct && i >= 2 && !substance) break;
    if (kind != nullptr && kind->meaning == ConstraintKind::Meaning::Words && i >= 1) break;
    uses.push_back(placeholder_use(constraint.arguments[i]));
  }
  return uses;
}

int capacity_of(const DomainConstraint& constraint) {
  const auto* kind = constraint_kind(constraint.kind);
  if (kind == nullptr || kind->meaning != ConstraintKind::Meaning::Placement || constraint.arguments.size() < 3)
    return 1;
  const auto& text = constraint.arguments[2];
  int value = 1;
  if (is_number(text)) std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::string substance_of(const DomainConstraint& constraint) {
  const auto* kind = constraint_kind(constraint.kind);
  if (kind == nullptr || kind->meaning != ConstraintKind::Meaning::Effect || constraint.arguments.size() < 3) return "";
  return constraint.arguments[2];
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
