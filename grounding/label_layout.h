#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/geometry.h"

namespace unietp {

/// A rectangle of the picture, pixels, y down.
struct LabelBox {
  Vec2 center = Vec2::Zero(), size = Vec2::Zero();
};
/// Whether the two share an area.
bool overlap(const LabelBox& a, const LabelBox& b);

/// A text that wants a place in a drawing.
struct Label {
  std::string words;
  std::vector<double> sizes_px;  // font sizes to try, the wished one first
  std::vector<Vec2> centers_px;  // places to try, the wished one first
  double crowding = 0;           // how many obstacles it may cover at most
};

/// Where a label goes, and its font size.
struct PlacedLabel {
  Vec2 center_px = Vec2::Zero();
  double size_px = 0;
};

/// Gives labels places, in their order, so that none overlaps another; each takes, size by size, the place that covers
/// the fewest obstacles, the first of equals. nullopt for a label without a place. Deterministic; linear in labels ×
/// places × boxes.
std::vector<std::optional<PlacedLabel>> place_labels(const std::vector<Label>& labels,
                                                     const std::vector<LabelBox>& obstacles);

}  // namespace unietp
