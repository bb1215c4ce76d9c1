#include "scene/fresh_id.h"

#include <algorithm>
#include <cctype>
#include <cstdint>

#include "core/rng.h"

namespace unietp {
namespace {

bool is_upper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
bool is_lower(char c) { return std::islower(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
char to_lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

/// "coffee_table.n.01" without its WordNet part of speech and sense number.
std::string_view without_sense(std::string_view category) {
  const auto n = category.size();
  const bool sense = n > 5 && category[n - 5] == '.' && is_lower(category[n - 4]) && category[n - 3] == '.' &&
                     is_digit(category[n - 2]) && is_digit(category[n - 1]);
  return sense ? category.substr(0, n - 5) : category;
}

/// "CoffeeMachine" → "coffee_machine", "TVStand" → "tv_stand", "wine glass" → "wine_glass".
std::string snake_case(std::string_view category) {
  std::string name;
  for (std::size_t i = 0; i < category.size(); ++i) {
    const char c = category[i];
    const bool letter = is_upper(c) || is_lower(c) || is_digit(c);
    const bool after_small = i > 0 && (is_lower(category[i - 1]) || is_digit(category[i - 1]));
    const bool before_small = i > 0 && i + 1 < category.size() && is_lower(category[i + 1]);
    const bool boundary = !letter || (is_upper(c) && (after_small || before_small));
    if (boundary && !name.empty() && name.back() != '_') name += '_';
    if (letter) name += to_lower(c);
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  return name.empty() ? "object" : name;
}

std::string stem_of(std::string_view category) { return snake_case(without_sense(category)) + "_"; }

bool is_free(const std::string& id, const Scene& scene, const NodeIndex& places) {
  const bool is_opening = std::any_of(scene.openings.begin(), scene.openings.end(),
                                      [&](const Opening& opening) { return opening.id == id; });
  return !places.find(id) && find_room(scene, id) == nullptr && !is_opening;
}

}  // namespace

std::string fresh_id(const Scene& scene, const NodeIndex& places, std::string_view category) {
  const std::string stem = stem_of(category);
  for (std::size_t number = 1;; ++number) {
    std::string id = stem + std::to_string(number);
    if (is_free(id, scene, places)) return id;
  }
}

std::string drawn_id(const Scene& scene, const NodeIndex& places, std::string_view category, const NodeIndex* before) {
  const std::string stem = stem_of(category);
  for (std::uint64_t numbers = 99;; numbers = 10 * numbers + 9) {
    if (2 * places.of(category).size() > numbers) continue;
    Rng rng = Rng(0).fork(scene.id, 1).fork(category, numbers);
    for (std::uint64_t tries = 4 * numbers; tries > 0; --tries) {  // other categories may have taken nearly all
      std::string id = stem + std::to_string(1 + rng.below(numbers));
      const bool was_there = before != nullptr && before->find(id);
      if (!was_there && is_free(id, scene, places)) return id;
    }
  }
}

std::string fresh_id(const Scene& scene, std::string_view category) {
  return fresh_id(scene, NodeIndex(scene.nodes), category);
}

}  // namespace unietp
