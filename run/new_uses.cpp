#include "run/new_uses.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/rng.h"
#include "generator/phrase_kind.h"

namespace unietp {
namespace {

constexpr double kUsedBefore = 0.02;  // times the weight, for each task that called a thing of the kind so
constexpr double kOtherPart = 0.03;   // likewise, of kinds that other blocks prefer

/// The narrowest kind of a category that has words of the style; "" for any other.
std::string use_of(const std::string& category, Style style, const Knowledge& knowledge) {
  if (knowledge.aliases_of(category, phrases_of(style)).empty()) return "";
  const auto& kinds = knowledge.find(category)->kinds;
  return kinds.empty() ? "" : kinds.front();
}

}  // namespace

std::vector<Trait> uses_of(const Template& source, const Binding& binding, std::optional<Style> style,
                           const Knowledge& knowledge) {
  std::vector<Trait> uses;
  if (!style || !names_by_phrase(*style)) return uses;
  for (std::size_t i = 0; i < binding.size(); ++i) {
    if (is_value(source.parameters[i]) || dimension_of(source.parameters[i], source) != Dimension::Category) continue;
    Trait use{Dimension::Use, use_of(binding[i].second, *style, knowledge)};
    if (!use.value.empty() && std::find(uses.begin(), uses.end(), use) == uses.end()) uses.push_back(std::move(use));
  }
  std::sort(uses.begin(), uses.end(), [](const Trait& one, const Trait& other) { return one.value < other.value; });
  return uses;
}

CategoryWeight with_new_uses(CategoryWeight plain, const UseWishes& wishes, const Template& source,
                             const Knowledge& knowledge, const Frequencies& counts) {
  if (!wishes.style || !names_by_phrase(*wishes.style)) return plain;
  return [plain = std::move(plain), wishes, &source, &knowledge, &counts](const Parameter& parameter,
                                                                          const std::string& category) {
    const double weight = plain(parameter, category);
    if (is_value(parameter) || dimension_of(parameter, source) != Dimension::Category) return weight;
    const std::string use = use_of(category, *wishes.style, knowledge);
    if (use.empty()) return weight;
    const auto part = Rng(wishes.seed).fork("use " + use, 0).below(kUseParts);
    const double own = static_cast<int>(part) == wishes.part % kUseParts ? 1 : kOtherPart;
    return weight * own * std::pow(kUsedBefore, counts.count(Dimension::Use, use));
  };
}

}  // namespace unietp
