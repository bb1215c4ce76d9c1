#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/geometry.h"

namespace unietp {

/// An SVG under way. Points are meters in W seen from above, +y up; lengths named _px are pixels of the picture.
class SvgCanvas {
 public:
  static constexpr double kPixelsPerMeter = 80;

  /// The part of W from `low` to `high`.
  SvgCanvas(const Vec2& low, const Vec2& high, std::string_view title);

  /// Where a point of W is in the picture, pixels from the upper left corner.
  Vec2 pixels(const Vec2& point) const;
  /// `style` are SVG attributes: fill="#fff" stroke="#000".
  void polygon(const std::vector<Vec2>& corners, std::string_view style);
  /// An open line through the points, and a circle; `radius` is in meters.
  void line(const std::vector<Vec2>& points, std::string_view style);
  void circle(const Vec2& center, double radius, std::string_view style);
  /// A rectangle with round corners, its size in pixels.
  void pill(const Vec2& center, const Vec2& size_px, std::string_view style);
  /// Centered on the point, in both directions.
  void text(const Vec2& center, double size_px, std::string_view style, std::string_view words);

  /// What follows belongs together; a pointer that rests on it shows the words.
  void begin_group(std::string_view words);
  void end_group();

  /// The whole SVG. Equal calls give equal bytes.
  std::string finish() &&;

 private:
  std::string coordinates(const std::vector<Vec2>& points) const;

  Vec2 low_, high_;
  std::string svg_;
};

/// Width and height in pixels that a text takes, a little more than most fonts need.
Vec2 text_extent_px(std::string_view words, double size_px);

}  // namespace unietp
