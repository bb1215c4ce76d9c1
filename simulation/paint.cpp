#include "simulation/paint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "simulation/noise.h"

namespace unietp {
namespace {

struct Named {
  std::string_view name;
  std::array<double, 3> color;
};

constexpr std::array<Named, 32> kSubstances{
    {{"coffee", {62, 38, 22}},    {"wine", {92, 12, 36}},        {"milk", {246, 244, 236}},
     {"cream", {246, 240, 222}},  {"tea", {150, 86, 34}},        {"juice", {238, 158, 44}},
     {"beer", {216, 154, 44}},    {"cola", {48, 24, 16}},        {"sauce", {150, 40, 22}},
     {"ketchup", {180, 26, 20}},  {"jam", {150, 20, 50}},        {"chocolate", {76, 42, 24}},
     {"soap", {120, 190, 120}},   {"detergent", {84, 130, 214}}, {"oil", {214, 186, 60}},
     {"honey", {220, 150, 30}},   {"blood", {130, 10, 14}},      {"mud", {86, 60, 36}},
     {"soil", {70, 48, 32}},      {"dirt", {86, 64, 44}},        {"dust", {172, 166, 156}},
     {"ash", {120, 118, 116}},    {"rust", {164, 78, 34}},       {"moss", {92, 120, 50}},
     {"mold", {96, 122, 96}},     {"paint", {60, 110, 190}},     {"ink", {30, 30, 80}},
     {"snow", {244, 248, 252}},   {"flour", {244, 240, 230}},    {"sugar", {248, 246, 242}},
     {"mustard", {214, 170, 30}}, {"water", {116, 176, 224}}}};

Color color(const std::array<double, 3>& rgb) { return {rgb[0], rgb[1], rgb[2]}; }
Color color(const Rgb& rgb) { return {1.0 * rgb[0], 1.0 * rgb[1], 1.0 * rgb[2]}; }

/// Whether things of this material mostly have its own color.
bool has_color(Matter matter) {
  switch (matter) {
    case Matter::Metal:
    case Matter::Glass:
    case Matter::Wood:
    case Matter::Leather:
    case Matter::Stone:
    case Matter::Cardboard:
    case Matter::Wicker:
      return true;
    default:
      return false;
  }
}

/// Default color of furniture by archetype.
Color plain_paint(const Node& node) {
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
  return color(kSmall[number_of(node.category) % kSmall.size()]);
}

}  // namespace

Color paint_of(const Node& node, const ShapeFamily* family) {
  const Rgb* known = color_named(node.color);
  const Material* material = material_named(node.material);
  const bool telling = material != nullptr && has_color(material->matter);
  if (known == nullptr && !telling && family != nullptr) {
    const std::string* usual = usual_color(*family, number_of(node.id));
    if (usual != nullptr) known = color_named(*usual);
  }
  const Color base = known != nullptr      ? color(*known)
                     : material != nullptr ? color(material->color)
                                           : plain_paint(node);
  constexpr double kShade = 0.09;  // lightest against darkest
  return base * (1 - kShade / 2 + kShade * (number_of(node.id) % 16) / 15.0);
}

Matter matter_of(const Node& node, const ShapeFamily* family) {
  if (const Material* known = material_named(node.material)) return known->matter;
  if (const Material* usual = family == nullptr ? nullptr : material_named(family->material)) return usual->matter;
  for (const Predicate state : {Predicate::Cooked, Predicate::Raw, Predicate::Whole, Predicate::Sliced}) {
    if (node.states.has(state)) return Matter::Food;
  }
  if (!node.slice_of.empty()) return Matter::Food;
  for (const Predicate state : {Predicate::Folded, Predicate::Unfolded, Predicate::Soaked, Predicate::Dry}) {
    if (node.states.has(state)) return Matter::Fabric;
  }
  switch (node.archetype) {
    case Archetype::Table:
    case Archetype::Shelf:
    case Archetype::Drawers:
    case Archetype::Cabinet:
      return Matter::Wood;
    case Archetype::Seat:
    case Archetype::Bed:
      return Matter::Fabric;
    case Archetype::Basin:
      return Matter::Ceramic;
    default:
      return Matter::Plain;
  }
}

Color substance_paint(std::string_view substance) {
  for (const Named& known : kSubstances) {
    if (substance.find(known.name) != std::string_view::npos) return color(known.color);
  }
  return {226, 206, 140};
}

}  // namespace unietp
