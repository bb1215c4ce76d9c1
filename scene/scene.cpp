#include "scene/scene.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <tuple>

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

/// The n of "<stem>_n" written without leading zeros, else 0.
std::size_t number_after(std::string_view stem, std::string_view id) {
  if (id.size() < stem.size() + 2 || !id.starts_with(stem) || id[stem.size()] != '_' || id[stem.size() + 1] == '0') {
    return 0;
  }
  const std::string_view digits = id.substr(stem.size() + 1);
  std::size_t number = 0;
  const auto [end, failed] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return failed == std::errc() && end == digits.data() + digits.size() ? number : 0;
}

}  // namespace

const Node* find_node(const Scene& scene, std::string_view id) {
  const auto found = std::find_if(scene.nodes.begin(), scene.nodes.end(), [id](const Node& n) { return n.id == id; });
  return found == scene.nodes.end() ? nullptr : &*found;
}

Node* edit_node(Scene& scene, std::string_view id) {
  const auto found = std::find_if(scene.nodes.begin(), scene.nodes.end(), [id](const Node& n) { return n.id == id; });
  return found == scene.nodes.end() ? nullptr
                                    : &scene.nodes.edit(static_cast<std::size_t>(found - scene.nodes.begin()));
}

const Room* find_room(const Scene& scene, std::string_view id) {
  const auto found = std::find_if(scene.rooms.begin(), scene.rooms.end(), [id](const Room& r) { return r.id == id; });
  return found == scene.rooms.end() ? nullptr : &*found;
}

bool has_edge(const Scene& scene, Predicate relation, std::string_view from, std::string_view to) {
  using Key = std::tuple<Predicate, std::string_view, std::string_view>;
  const Key wanted{relation, from, to};
  const auto key_of = [](const Edge& edge) { return Key{edge.relation, edge.from, edge.to}; };
  const auto place = scene.edges.partition_point([&](const Edge& edge) { return key_of(edge) < wanted; });
  return place != scene.edges.end() && key_of(*place) == wanted;
}

const Room* room_at(const Scene& scene, const Vec2& point) {
  const auto found = std::find_if(scene.rooms.begin(), scene.rooms.end(),
                                  [&](const Room& room) { return contains(room.polygon, point); });
  return found == scene.rooms.end() ? nullptr : &*found;
}

std::string fresh_id(const Scene& scene, std::string_view category) {
  const std::string stem = snake_case(without_sense(category));
  // n ids cannot take all of 1 … n + 1. Rooms and openings count too: all share the names that an action may say.
  const std::size_t count = scene.nodes.size() + scene.rooms.size() + scene.openings.size();
  std::vector<bool> taken(count + 2, false);
  const auto take = [&](const auto& items) {
    for (const auto& item : items) {
      if (const std::size_t number = number_after(stem, item.id); number <= count) taken[number] = true;
    }
  };
  take(scene.nodes);
  take(scene.rooms);
  take(scene.openings);
  const auto free = std::find(taken.begin() + 1, taken.end(), false);
  return stem + "_" + std::to_string(free - taken.begin());
}

}  // namespace unietp
