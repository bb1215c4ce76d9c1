#include "grounding/label_layout.h"

#include <algorithm>
#include <cmath>

#include "grounding/svg_canvas.h"

namespace unietp {

bool overlap(const LabelBox& a, const LabelBox& b) {
  const Vec2 apart = (a.center - b.center).cwiseAbs(), reach = (a.size + b.size) / 2;
  return apart.x() < reach.x() && apart.y() < reach.y();
}

std::vector<std::optional<PlacedLabel>> place_labels(const std::vector<Label>& labels,
                                                     const std::vector<LabelBox>& obstacles) {
  std::vector<std::optional<PlacedLabel>> placed;
  std::vector<LabelBox> taken;
  for (const Label& label : labels) {
    std::optional<PlacedLabel> best;
    double fewest = label.crowding + 0.5;
    for (const double size : label.sizes_px) {
      for (const Vec2& center : label.centers_px) {
        const LabelBox box{center, text_extent_px(label.words, size)};
        const auto covers = [&](const LabelBox& other) { return overlap(box, other); };
        if (std::any_of(taken.begin(), taken.end(), covers)) continue;
        const auto covered = static_cast<double>(std::count_if(obstacles.begin(), obstacles.end(), covers));
        if (covered >= fewest) continue;
        fewest = covered;
        best = PlacedLabel{center, size};
      }
      if (best) break;
    }
    if (best) taken.push_back({best->center_px, text_extent_px(label.words, best->size_px)});
    placed.push_back(best);
  }
  return placed;
}

}  // namespace unietp
