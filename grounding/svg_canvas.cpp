#include "grounding/svg_canvas.h"

#include <cmath>

#include "core/text.h"

namespace unietp {
namespace {

constexpr double kWidthPerLetter = 0.6, kHeightPerSize = 1.2;  // of a sans-serif font

std::string escaped(std::string_view text) {
  return replace_all(replace_all(replace_all(std::string(text), "&", "&amp;"), "<", "&lt;"), ">", "&gt;");
}

/// Two decimals are finer than a screen shows.
std::string px(double value) { return number_text(std::round(value * 100) / 100 + 0.0); }

std::string attributes(std::string_view style) { return style.empty() ? "" : " " + std::string(style); }

}  // namespace

SvgCanvas::SvgCanvas(const Vec2& low, const Vec2& high, std::string_view title) : low_(low), high_(high) {
  const Vec2 size = (high_ - low_) * kPixelsPerMeter;
  svg_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + px(size.x()) + "\" height=\"" + px(size.y()) +
         "\" viewBox=\"0 0 " + px(size.x()) + " " + px(size.y()) +
         "\" font-family=\"Helvetica, Arial, sans-serif\">\n<title>" + escaped(title) + "</title>\n" +
         "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
}

Vec2 SvgCanvas::pixels(const Vec2& point) const {
  return {(point.x() - low_.x()) * kPixelsPerMeter, (high_.y() - point.y()) * kPixelsPerMeter};
}

std::string SvgCanvas::coordinates(const std::vector<Vec2>& points) const {
  std::string text;
  for (const Vec2& point : points) {
    const Vec2 p = pixels(point);
    text += (text.empty() ? "" : " ") + px(p.x()) + "," + px(p.y());
  }
  return text;
}

void SvgCanvas::polygon(const std::vector<Vec2>& corners, std::string_view style) {
  svg_ += "<polygon points=\"" + coordinates(corners) + "\"" + attributes(style) + "/>\n";
}

void SvgCanvas::line(const std::vector<Vec2>& points, std::string_view style) {
  svg_ += "<polyline points=\"" + coordinates(points) + "\" fill=\"none\"" + attributes(style) + "/>\n";
}

void SvgCanvas::circle(const Vec2& center, double radius, std::string_view style) {
  const Vec2 p = pixels(center);
  svg_ += "<circle cx=\"" + px(p.x()) + "\" cy=\"" + px(p.y()) + "\" r=\"" + px(radius * kPixelsPerMeter) + "\"" +
          attributes(style) + "/>\n";
}

void SvgCanvas::pill(const Vec2& center, const Vec2& size_px, std::string_view style) {
  const Vec2 p = pixels(center);
  svg_ += "<rect x=\"" + px(p.x() - size_px.x() / 2) + "\" y=\"" + px(p.y() - size_px.y() / 2) + "\" width=\"" +
          px(size_px.x()) + "\" height=\"" + px(size_px.y()) + "\" rx=\"" + px(size_px.minCoeff() / 2) + "\"" +
          attributes(style) + "/>\n";
}

void SvgCanvas::text(const Vec2& center, double size_px, std::string_view style, std::string_view words) {
  const Vec2 p = pixels(center);
  svg_ += "<text x=\"" + px(p.x()) + "\" y=\"" + px(p.y()) + "\" font-size=\"" + px(size_px) +
          "\" text-anchor=\"middle\" dominant-baseline=\"central\"" + attributes(style) + ">" + escaped(words) +
          "</text>\n";
}

void SvgCanvas::begin_group(std::string_view words) { svg_ += "<g><title>" + escaped(words) + "</title>\n"; }
void SvgCanvas::end_group() { svg_ += "</g>\n"; }

std::string SvgCanvas::finish() && { return std::move(svg_) + "</svg>\n"; }

Vec2 text_extent_px(std::string_view words, double size_px) {
  return {static_cast<double>(words.size()) * kWidthPerLetter * size_px, kHeightPerSize * size_px};
}

}  // namespace unietp
