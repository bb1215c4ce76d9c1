#include "simulation/paint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace unietp {
namespace {

struct Named {
  std::string_view name;
  std::array<double, 3> colour;
};

constexpr std::array<Named, 19> kColours{{{"white", {240, 239, 234}},
                                          {"grey", {150, 150, 152}},
                                          {"silver", {190, 195, 200}},
                                          {"black", {52, 52, 56}},
                                          {"clear", {196, 220, 228}},
                                          {"transparent", {196, 220, 228}},
                                          {"red", {196, 62, 54}},
                                          {"green", {86, 150, 80}},
                                          {"blue", {66, 112, 180}},
                                          {"yellow", {230, 195, 70}},
                                          {"orange", {226, 138, 56}},
                                          {"brown", {136, 94, 60}},
                                          {"pink", {226, 156, 176}},
                                          {"purple", {132, 98, 164}},
                                          {"beige", {222, 206, 174}},
                                          {"gold", {208, 168, 64}},
                                          {"tan", {200, 166, 122}},
                                          {"turquoise", {80, 176, 170}},
                                          {"olive", {132, 134, 72}}}};
constexpr std::array<Named, 14> kMaterials{{{"plastic", {205, 205, 214}},
                                            {"metal", {172, 178, 186}},
                                            {"glass", {190, 216, 226}},
                                            {"wood", {176, 130, 84}},
                                            {"fabric", {150, 158, 186}},
                                            {"paper", {238, 232, 212}},
                                            {"ceramic", {236, 230, 222}},
                                            {"leather", {120, 78, 54}},
                                            {"stone", {160, 158, 152}},
                                            {"cardboard", {190, 154, 108}},
                                            {"rubber", {70, 70, 72}},
                                            {"wicker", {196, 162, 104}},
                                            {"wax", {240, 228, 190}},
                                            {"foam", {232, 216, 150}}}};

template <std::size_t N>
const Named* named(const std::array<Named, N>& table, std::string_view name) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const Named& entry) { return entry.name == name; });
  return found == table.end() ? nullptr : &*found;
}

Colour colour(const std::array<double, 3>& rgb) { return {rgb[0], rgb[1], rgb[2]}; }

/// FNV-1a: equal on every machine.
std::uint32_t number_of(std::string_view text) {
  std::uint32_t hash = 2166136261U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  return hash;
}

/// Default colour of furniture by archetype.
Colour plain_paint(const Node& node) {
  switch (node.archetype) {
    case Archetype::Table:
    case Archetype::Shelf:
    case Archetype::Drawers:
    case Archetype::Cabinet:
      return {186, 146, 100};
    case Archetype::Seat:
    case Archetype::Bed:
      return {128, 140, 168};
    case Archetype::Basin:
      return {230, 234, 236};
    case Archetype::Panel:
      return {150, 186, 204};
    case Archetype::Block:
      return {204, 196, 182};
    default:
      break;
  }
  // Small objects contrast with what they lie on, by category.
  constexpr std::array<std::array<double, 3>, 6> kSmall{
      {{206, 120, 84}, {120, 158, 110}, {104, 140, 186}, {214, 178, 92}, {168, 126, 170}, {196, 102, 112}}};
  return colour(kSmall[number_of(node.category) % kSmall.size()]);
}

}  // namespace

Colour paint_of(const Node& node) {
  const Named* known = named(kColours, node.colour);
  if (known == nullptr) known = named(kMaterials, node.material);
  const Colour base = known != nullptr ? colour(known->colour) : plain_paint(node);
  constexpr double kShade = 0.09;  // lightest against darkest
  return base * (1 - kShade / 2 + kShade * (number_of(node.id) % 16) / 15.0);
}

Colour floor_paint(const Room* room, const Vec2& at) {
  if (room == nullptr) return {150, 156, 150};
  const auto cell = [](double way, double size) { return static_cast<int>(std::floor(way / size)); };
  if (room->type == "kitchen" || room->type == "bathroom") {
    constexpr double kTile_m = 0.4;
    const bool dark = (cell(at.x(), kTile_m) + cell(at.y(), kTile_m)) % 2 != 0;
    return dark ? Colour(186, 190, 192) : Colour(204, 207, 208);
  }
  constexpr double kBoard_m = 0.16;
  constexpr std::array<double, 3> kShades{1.0, 0.94, 0.97};
  const int board = cell(at.y(), kBoard_m);
  return Colour(190, 156, 116) * kShades[static_cast<std::size_t>(((board % 3) + 3) % 3)];
}

}  // namespace unietp
