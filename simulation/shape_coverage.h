#pragma once

#include <cstddef>
#include <vector>

#include "akb/knowledge.h"
#include "shapes/library.h"

namespace unietp {

/// A category of a simulator that has a shape.
struct ShownCategory {
  const Knowledge* knowledge = nullptr;
  const Category* category = nullptr;
};
/// The categories that a built-in family shows, in the order of the knowledge.
std::vector<ShownCategory> shown_by(const ShapeFamily& family, const std::vector<const Knowledge*>& knowledge);

/// How many categories of a simulator have a shape.
struct ShapeCoverage {
  std::size_t movable = 0, movable_shown = 0;  // categories that the agent moves; those with a shape
  std::size_t others = 0, others_shown = 0;    // furniture and fixtures
  std::size_t plain_boxes = 0;                 // movable, without a shape, and a box as archetype
};
ShapeCoverage shape_coverage(const Knowledge& knowledge);

}  // namespace unietp
