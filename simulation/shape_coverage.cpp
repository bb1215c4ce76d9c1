#include "simulation/shape_coverage.h"

namespace unietp {

std::vector<ShownCategory> shown_by(const ShapeFamily& family, const std::vector<const Knowledge*>& knowledge) {
  std::vector<ShownCategory> shown;
  for (const Knowledge* one : knowledge) {
    for (const Category& category : one->categories()) {
      if (built_in_shapes().family_of(one->simulator(), category.name, category.archetype) == &family)
        shown.push_back({one, &category});
    }
  }
  return shown;
}

ShapeCoverage shape_coverage(const Knowledge& knowledge) {
  ShapeCoverage coverage;
  for (const Category& category : knowledge.categories()) {
    const bool shown = built_in_shapes().family_of(knowledge.simulator(), category.name, category.archetype) != nullptr;
    if (category.movable) {
      ++coverage.movable;
      coverage.movable_shown += shown ? 1 : 0;
      coverage.plain_boxes += !shown && category.archetype == Archetype::Box ? 1 : 0;
    } else {
      ++coverage.others;
      coverage.others_shown += shown ? 1 : 0;
    }
  }
  return coverage;
}

}  // namespace unietp
