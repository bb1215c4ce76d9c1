#include "grounding/furniture_position.h"

#include <array>
#include <charconv>
#include <utility>

#include "core/text.h"

namespace unietp {
namespace {

constexpr double kHighest_m = 2.5;
using Kind = FurniturePosition::Kind;
constexpr std::array<std::pair<std::string_view, Kind>, 13> kKinds{{{"wall", Kind::Wall},
                                                                    {"run", Kind::Run},
                                                                    {"facing", Kind::Facing},
                                                                    {"corner", Kind::Corner},
                                                                    {"centre", Kind::Centre},
                                                                    {"wall-hung", Kind::WallHung},
                                                                    {"outer-wall", Kind::OuterWall},
                                                                    {"ceiling", Kind::Ceiling},
                                                                    {"on", Kind::On},
                                                                    {"at", Kind::At},
                                                                    {"beside", Kind::Beside},
                                                                    {"before", Kind::Before},
                                                                    {"above", Kind::Above}}};

bool takes_host(Kind kind) {
  return kind == Kind::On || kind == Kind::At || kind == Kind::Beside || kind == Kind::Before || kind == Kind::Facing ||
         kind == Kind::Above;
}
bool takes_height(Kind kind) {
  return kind == Kind::WallHung || kind == Kind::OuterWall || kind == Kind::Facing || kind == Kind::Above;
}

}  // namespace

std::optional<FurniturePosition> parse_furniture_position(std::string_view text) {
  const auto parts = split(text, ':');
  std::optional<FurniturePosition> where;
  for (const auto& [name, kind] : kKinds) {
    if (parts.front() == name) where = FurniturePosition{kind, "", std::nullopt};
  }
  if (!where) return std::nullopt;
  std::size_t used = 1;
  if (takes_host(where->kind)) {
    if (parts.size() < 2 || parts[1].empty()) return std::nullopt;
    where->host = parts[1];
    used = 2;
  }
  if (parts.size() == used) return where;
  if (!takes_height(where->kind) || parts.size() != used + 1) return std::nullopt;
  double height = 0;
  const std::string& number = parts[used];
  const auto [end, failed] = std::from_chars(number.data(), number.data() + number.size(), height);
  if (failed != std::errc() || end != number.data() + number.size()) return std::nullopt;
  if (!(height >= 0 && height <= kHighest_m)) return std::nullopt;  // nan too
  where->height_m = height;
  return where;
}

}  // namespace unietp
