#include "grounding/furniture_position.h"

#include <array>
#include <charconv>
#include <utility>

#include "core/text.h"

namespace unietp {
namespace {

constexpr double kHighest_m = 2.5;
using PositionKind = FurniturePosition::Kind;
constexpr std::array<std::pair<std::string_view, PositionKind>, 13> kKinds{{{"wall", PositionKind::Wall},
                                                                            {"run", PositionKind::Run},
                                                                            {"facing", PositionKind::Facing},
                                                                            {"corner", PositionKind::Corner},
                                                                            {"centre", PositionKind::Center},
                                                                            {"wall-hung", PositionKind::WallHung},
                                                                            {"outer-wall", PositionKind::OuterWall},
                                                                            {"ceiling", PositionKind::Ceiling},
                                                                            {"on", PositionKind::On},
                                                                            {"at", PositionKind::At},
                                                                            {"beside", PositionKind::Beside},
                                                                            {"before", PositionKind::Before},
                                                                            {"above", PositionKind::Above}}};

bool takes_host(PositionKind kind) {
  return kind == PositionKind::On || kind == PositionKind::At || kind == PositionKind::Beside ||
         kind == PositionKind::Before || kind == PositionKind::Facing || kind == PositionKind::Above;
}
bool takes_height(PositionKind kind) {
  return kind == PositionKind::WallHung || kind == PositionKind::OuterWall || kind == PositionKind::Facing ||
         kind == PositionKind::Beside || kind == PositionKind::Above;
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
