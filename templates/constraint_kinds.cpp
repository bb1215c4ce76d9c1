#include "templates/constraint_kinds.h"

#include <array>
#include <charconv>

namespace unietp {
namespace {

using enum ConstraintKind::Meaning;

constexpr std::array<ConstraintKind, 17> kKinds = {{
    {"distinct", Distinct, "", "(distinct A B ...)", "the placeholders get different categories"},
    {"fits-on", Placement, "on", "(fits-on A B [n])", "a B carries at least n A at once (1 when left out)"},
    {"fits-inside", Placement, "inside", "(fits-inside A B [n])", "a B holds at least n A at once (1 when left out)"},
    {"fits-next-to", Placement, "next_to", "(fits-next-to A B [n])", "at least n A find room beside a B"},
    {"fits-under", Placement, "under", "(fits-under A B [n])", "at least n A find room under a B"},
    {"heats", Effect, "heats", "(heats T A)", "a T makes an A hot"},
    {"cools", Effect, "cools", "(cools T A)", "a T makes an A cool"},
    {"freezes", Effect, "freezes", "(freezes T A)", "a T freezes an A"},
    {"washes", Effect, "washes", "(washes T A)", "a T makes an A clean"},
    {"wipes", Effect, "wipes", "(wipes T A)", "an A is wiped clean with a T"},
    {"cooks", Effect, "cooks", "(cooks T A)", "a T cooks an A"},
    {"burns", Effect, "burns", "(burns T A)", "a T burns an A"},
    {"slices", Effect, "slices", "(slices K A)", "a K cuts an A"},
    {"soaks", Effect, "soaks", "(soaks T A)", "a T soaks an A"},
    {"fills", Effect, "fills", "(fills T A substance)", "a T fills an A with the substance"},
    {"dispenses", Effect, "dispenses", "(dispenses T A substance)", "a T spreads the substance over an A"},
    {"drains", Effect, "drains", "(drains T A)", "an A is emptied into a T"},
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
    if (kind != nullptr && kind->meaning != Distinct && i >= 2) break;
    uses.push_back(placeholder_use(constraint.arguments[i]));
  }
  return uses;
}

int capacity_of(const DomainConstraint& constraint) {
  const auto* kind = constraint_kind(constraint.kind);
  if (kind == nullptr || kind->meaning != Placement || constraint.arguments.size() < 3) return 1;
  const auto& text = constraint.arguments[2];
  int value = 1;
  if (is_number(text)) std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::string substance_of(const DomainConstraint& constraint) {
  const auto* kind = constraint_kind(constraint.kind);
  if (kind == nullptr || kind->meaning != Effect || constraint.arguments.size() < 3) return "";
  return constraint.arguments[2];
}

const std::vector<std::string>& pseudo_affordances() {
  static const std::vector<std::string> kNames = {"furniture", "movable", "countable", "room", "any"};
  return kNames;
}

}  // namespace unietp
