#include "shapes/matter.h"

#include <algorithm>

namespace unietp {
namespace {

struct NamedColor {
  std::string_view name;
  Rgb color{};
};

// Those of the knowledge tables first, then those that shapes alone use.
constexpr std::array<NamedColor, 41> kColors{
    {{"white", {240, 239, 234}},     {"grey", {150, 150, 152}},   {"silver", {190, 195, 200}},
     {"black", {52, 52, 56}},        {"clear", {196, 220, 228}},  {"transparent", {196, 220, 228}},
     {"red", {196, 62, 54}},         {"green", {86, 150, 80}},    {"blue", {66, 112, 180}},
     {"yellow", {230, 195, 70}},     {"orange", {226, 138, 56}},  {"brown", {136, 94, 60}},
     {"pink", {226, 156, 176}},      {"purple", {132, 98, 164}},  {"beige", {222, 206, 174}},
     {"gold", {208, 168, 64}},       {"tan", {200, 166, 122}},    {"turquoise", {80, 176, 170}},
     {"olive", {132, 134, 72}},      {"steel", {172, 178, 186}},  {"charcoal", {70, 72, 78}},
     {"cream", {244, 234, 206}},     {"crust", {190, 126, 62}},   {"crumb", {236, 208, 152}},
     {"cheese", {240, 196, 84}},     {"chocolate", {88, 52, 32}}, {"meat", {176, 84, 72}},
     {"roast", {140, 80, 44}},       {"salmon", {236, 142, 108}}, {"leaf", {70, 128, 58}},
     {"lettuce", {146, 190, 90}},    {"lime", {150, 190, 70}},    {"soil", {74, 54, 38}},
     {"terracotta", {190, 104, 70}}, {"oak", {176, 130, 84}},     {"walnut", {112, 76, 50}},
     {"pine", {214, 176, 124}},      {"straw", {220, 190, 120}},  {"navy", {48, 62, 104}},
     {"glass", {190, 216, 226}},     {"screen", {20, 22, 26}}}};
constexpr std::array<Material, 16> kMaterials{{{"plastic", {205, 205, 214}, Matter::Plastic},
                                               {"metal", {172, 178, 186}, Matter::Metal},
                                               {"glass", {190, 216, 226}, Matter::Glass},
                                               {"wood", {176, 130, 84}, Matter::Wood},
                                               {"fabric", {150, 158, 186}, Matter::Fabric},
                                               {"paper", {238, 232, 212}, Matter::Paper},
                                               {"ceramic", {236, 230, 222}, Matter::Ceramic},
                                               {"leather", {120, 78, 54}, Matter::Leather},
                                               {"stone", {160, 158, 152}, Matter::Stone},
                                               {"cardboard", {190, 154, 108}, Matter::Cardboard},
                                               {"rubber", {70, 70, 72}, Matter::Rubber},
                                               {"wicker", {196, 162, 104}, Matter::Wicker},
                                               {"wax", {240, 228, 190}, Matter::Wax},
                                               {"foam", {232, 216, 150}, Matter::Foam},
                                               {"food", {206, 150, 90}, Matter::Food},
                                               {"plain", {206, 200, 190}, Matter::Plain}}};

template <class Entry, std::size_t N>
const Entry* named(const std::array<Entry, N>& table, std::string_view name) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const Entry& entry) { return entry.name == name; });
  return found == table.end() ? nullptr : &*found;
}

template <class Table>
std::vector<std::string> names_of(const Table& table) {
  std::vector<std::string> names;
  for (const auto& entry : table) names.emplace_back(entry.name);
  return names;
}

}  // namespace

const Rgb* color_named(std::string_view name) {
  const NamedColor* found = named(kColors, name);
  return found == nullptr ? nullptr : &found->color;
}

const Material* material_named(std::string_view name) { return named(kMaterials, name); }

std::vector<std::string> color_names() { return names_of(kColors); }
std::vector<std::string> material_names() { return names_of(kMaterials); }

}  // namespace unietp
