#include "run/styles_of_slots.h"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include "generator/style_fit.h"

namespace unietp {
namespace {

constexpr int kStylesOfASlot = 3;

using Counts = std::array<int, kStyleCount>;

std::size_t position(Style style) { return static_cast<std::size_t>(style); }

/// How many slots are dealt a style for ten of another. Goals by function and by kind have many words to be said in,
/// which more tasks show; of the others that have more, fewer goals find their words. "A couple of mugs" still names
/// its category, as "if the lamp is on, turn it off" and "I'd like a hot potato" do, and so these have fewer.
int share_of(Style style) {
  switch (style) {
    case Style::Function:
    case Style::Context:
    case Style::Hypernym:
      return 60;
    case Style::Request:
      return 30;
    case Style::Anaphora:
      return 14;
    case Style::Condition:
    case Style::ImplicitNeed:
    case Style::VagueQuantity:
      return 6;
    default:
      return 10;
  }
}

/// The styles that some template of the slot fits and that the slot does not have yet.
std::vector<Style> open_styles(const TaskSlot& slot, const std::vector<std::vector<Style>>& styles) {
  std::array<bool, kStyleCount> fitting{};
  for (const std::size_t source : slot.templates)
    for (const Style style : styles[source]) fitting[position(style)] = true;
  for (const Style had : slot.styles) fitting[position(had)] = false;
  std::vector<Style> open;
  for (std::size_t i = 0; i < kStyleCount; ++i)
    if (fitting[i]) open.push_back(static_cast<Style>(i));
  return open;
}

/// Each slot takes the style dealt least often for its share; among equals the one dealt least often on its simulator,
/// so that templates for one simulator find their style there, then the one that fits the fewest slots, then a random
/// one.
void deal_one_each(std::vector<TaskSlot>& slots, const std::vector<std::vector<Style>>& styles, Rng rng) {
  Counts dealt{}, fitted{};
  std::map<Simulator, Counts> dealt_on;
  std::vector<std::vector<Style>> open;
  for (const TaskSlot& slot : slots) {
    open.push_back(slot.split == Split::Linguistic ? open_styles(slot, styles) : std::vector<Style>());
    for (const Style style : open.back()) ++fitted[position(style)];
  }
  for (std::size_t i = 0; i < slots.size(); ++i) {
    std::vector<Style> least;
    Counts& dealt_here = dealt_on[slots[i].simulator];
    const auto rank = [&](Style style) {
      const std::size_t at = position(style);
      return std::tuple(dealt[at] * 100 / share_of(style), dealt_here[at] * 100 / share_of(style), fitted[at]);
    };
    for (const Style style : open[i]) {
      if (!least.empty() && rank(style) > rank(least.front())) continue;
      if (!least.empty() && rank(style) < rank(least.front())) least.clear();
      least.push_back(style);
    }
    if (least.empty()) continue;
    slots[i].styles.push_back(rng.pick(least));
    ++dealt[position(slots[i].styles.back())];
    ++dealt_here[position(slots[i].styles.back())];
  }
}

}  // namespace

std::vector<std::vector<Style>> styles_of_templates(const std::vector<Template>& templates) {
  std::vector<std::vector<Style>> styles;
  for (const Template& source : templates) styles.push_back(styles_fitting(source));
  return styles;
}

bool is_among(Style style, const std::vector<Style>& styles) {
  return std::find(styles.begin(), styles.end(), style) != styles.end();
}

void deal_styles(std::vector<TaskSlot>& slots, const std::vector<std::vector<Style>>& styles, Rng rng) {
  for (std::uint64_t i = 0; i < kStylesOfASlot; ++i) deal_one_each(slots, styles, rng.fork("rank", i));
}

}  // namespace unietp
