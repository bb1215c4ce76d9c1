#pragma once

#include <cstddef>

/// Limits on the files of shapes, as in core/limits.h.
namespace unietp::limits {

// A picture draws some hundreds of objects, and a shape file is a table that people write.
inline constexpr std::size_t kShapeParts = 10'000;  // of the families of one file
inline constexpr std::size_t kShapeNumbers = 200;   // of one part
inline constexpr std::size_t kShapePieces = 120;    // that one object is drawn of
inline constexpr double kShapeNumber = 1000;        // that a shape file may write, up or down from 0

}  // namespace unietp::limits
