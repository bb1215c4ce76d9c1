#include "grounding/node_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "simulation/shape.h"
#include "simulation/solids.h"

namespace unietp {
namespace {

struct Fill {
  Archetype archetype;
  std::string_view color;
};
constexpr std::array<Fill, 10> kFills{{{Archetype::Block, "#e4e2dc"},
                                       {Archetype::Table, "#ecd8b4"},
                                       {Archetype::Seat, "#c9dbef"},
                                       {Archetype::Bed, "#dad4ee"},
                                       {Archetype::Shelf, "#e2cca6"},
                                       {Archetype::Cabinet, "#ddc79f"},
                                       {Archetype::Drawers, "#ddc79f"},
                                       {Archetype::Basin, "#eef5f7"},
                                       {Archetype::Panel, "#a9cfe0"},
                                       {Archetype::Fixture, "#cfcdc7"}}};

/// The tables' words for colors, in shades that sit well together.
constexpr std::array<std::pair<std::string_view, std::string_view>, 19> kColors{{{"white", "#fbfaf6"},
                                                                                 {"grey", "#a4a4a4"},
                                                                                 {"silver", "#c2c6ca"},
                                                                                 {"black", "#3f3f42"},
                                                                                 {"clear", "#dcecf0"},
                                                                                 {"transparent", "#dcecf0"},
                                                                                 {"red", "#c8483f"},
                                                                                 {"green", "#5f9a58"},
                                                                                 {"blue", "#4a78b5"},
                                                                                 {"yellow", "#e6c34a"},
                                                                                 {"orange", "#e08f3c"},
                                                                                 {"brown", "#8f6440"},
                                                                                 {"pink", "#e2a0b2"},
                                                                                 {"purple", "#8a6aa8"},
                                                                                 {"beige", "#e5d9bd"},
                                                                                 {"gold", "#d3ab45"},
                                                                                 {"tan", "#cfae83"},
                                                                                 {"turquoise", "#58b3ad"},
                                                                                 {"olive", "#87884a"}}};
constexpr std::string_view kUnknownColor = "#d8b48a";

std::string_view color_of(const Node& node) {
  const auto found =
      std::find_if(kColors.begin(), kColors.end(), [&](const auto& known) { return known.first == node.color; });
  return found == kColors.end() ? kUnknownColor : found->second;
}

std::string_view fill_of(Archetype archetype) {
  const auto found =
      std::find_if(kFills.begin(), kFills.end(), [&](const Fill& f) { return f.archetype == archetype; });
  return found == kFills.end() ? "#e4e2dc" : found->color;
}

/// Lines in a node's frame, as shares of its half size: (-1, -1) is the front left corner.
class Marks {
 public:
  Marks(SvgCanvas& canvas, const Node& node) : canvas_(canvas), node_(node) {}

  void line(double x0, double y0, double x1, double y1, std::string_view style) {
    canvas_.line({at(x0, y0), at(x1, y1)}, style);
  }
  void area(double x0, double y0, double x1, double y1, std::string_view style) {
    canvas_.polygon({at(x0, y0), at(x1, y0), at(x1, y1), at(x0, y1)}, style);
  }
  Vec2 at(double x, double y) const {
    return (node_.pose * Vec3(x * node_.size.x() / 2, y * node_.size.y() / 2, 0)).head<2>();
  }

 private:
  SvgCanvas& canvas_;
  const Node& node_;
};

constexpr std::string_view kThin = "stroke=\"#8d8573\" stroke-width=\"0.9\"";
constexpr std::string_view kFront = "stroke=\"#a85f34\" stroke-width=\"2.4\" stroke-linecap=\"round\"";

void draw_kind(SvgCanvas& canvas, const Node& node) {
  Marks mark(canvas, node);
  switch (node.archetype) {
    case Archetype::Seat:
      mark.area(-1, 0.62, 1, 1, "fill=\"#9fbbd8\" stroke=\"#8d8573\" stroke-width=\"0.9\"");
      break;
    case Archetype::Bed:
      mark.area(-1, 0.92, 1, 1, "fill=\"#8f84b8\"");
      for (const double side : {-1.0, 1.0})
        mark.area(side * 0.1, 0.52, side * 0.85, 0.84, "fill=\"#ffffff\" stroke=\"#a89fd0\" stroke-width=\"0.9\"");
      mark.line(-1, 0.3, 1, 0.3, "stroke=\"#a89fd0\" stroke-width=\"0.9\"");
      break;
    case Archetype::Shelf:
      for (const double y : {-0.3, 0.3}) mark.line(-1, y, 1, y, kThin);
      break;
    case Archetype::Drawers:
      mark.line(-1, -0.7, 1, -0.7, kThin);
      break;
    case Archetype::Basin:
      mark.area(-0.8, -0.75, 0.8, 0.7, "fill=\"#cfe5ee\" stroke=\"#8fb4c4\" stroke-width=\"0.9\"");
      break;
    default:
      break;
  }
}

/// The parts on joints, at the node's opening; closed ones show as a line along the front.
void draw_front(SvgCanvas& canvas, const Node& node) {
  if (!node.openable) return;
  if (node.opening <= 0) {
    Marks(canvas, node).line(-0.75, -1, 0.75, -1, kFront);
    return;
  }
  const Shape shape = shape_of(node);
  for (const Part& part : shape.parts) {
    if (part.joint < 0) continue;
    const Pose pose = node.pose * joint_motion(shape, part.joint, node.opening) * part.pose;
    canvas.polygon(footprint_of(pose, part.size), "fill=\"#ead9bd\" stroke=\"#a85f34\" stroke-width=\"1.2\"");
  }
}

bool is_round(Archetype archetype) {
  return archetype == Archetype::Cylinder || archetype == Archetype::Sphere || archetype == Archetype::Plate ||
         archetype == Archetype::Vessel;
}

/// The point of a shape's solid that is farthest in a level direction.
Vec3 farthest_point(const Solid& solid, const Vec3& way) {
  const Vec3 along = solid.axes.transpose() * way;
  if (solid.kind == SolidKind::Sphere) return solid.pose.position + solid.axes * along.normalized();
  const bool round = solid.kind == SolidKind::Cylinder || solid.kind == SolidKind::Cone || solid.kind == SolidKind::Cup;
  const auto at_end = [&](double end) {
    const Vec2& wide = end < 0 ? solid.low : solid.high;
    Vec2 aside = along.head<2>().cwiseProduct(wide);
    if (round) {
      aside = aside.norm() > 0 ? Vec2(aside.normalized().cwiseProduct(wide)) : Vec2(Vec2::Zero());
    } else {
      aside = {std::copysign(wide.x(), along.x()), std::copysign(wide.y(), along.y())};
    }
    return Vec3(solid.pose.position + solid.axes * Vec3(aside.x(), aside.y(), end));
  };
  const Vec3 low = at_end(-1), high = at_end(1);
  return low.dot(way) > high.dot(way) ? low : high;
}

/// The outline from above of all that a thing is seen as, without what shows its states: its hull, in few corners.
/// Empty for what looks like its archetype.
std::vector<Vec2> outline_of(const Node& node, Simulator simulator) {
  constexpr int kWays = 16;
  constexpr double kSame_m = 0.001;
  const ShapeFamily* family = family_of(node, simulator);
  if (family == nullptr || family->keeps_body) return {};
  std::vector<Solid> solids;
  add_solids(node, 0, simulator, {}, solids);
  std::vector<Vec2> outline;
  for (int i = 0; i < kWays; ++i) {
    const double angle = (2 * i + 1) * std::numbers::pi / kWays;  // off the axes, along which many edges are
    const Vec3 way(std::cos(angle), std::sin(angle), 0);
    Vec3 most = node.pose.position;
    for (const Solid& solid : solids) {
      if (!solid.sheared || solid.skin != Skin::Body) continue;
      const Vec3 point = farthest_point(solid, way);
      if (point.dot(way) > most.dot(way)) most = point;
    }
    const Vec2 corner = most.head<2>();
    const bool known =
        !outline.empty() && ((outline.back() - corner).norm() < kSame_m || (outline.front() - corner).norm() < kSame_m);
    if (!known) outline.push_back(corner);
  }
  return outline.size() < 3 ? std::vector<Vec2>{} : outline;
}

/// Whether all corners are equally far from the middle.
bool is_circle(const std::vector<Vec2>& outline, const Vec2& middle) {
  constexpr double kRound = 0.03;
  double least = 1e9, most = 0;
  for (const Vec2& corner : outline) {
    least = std::min(least, (corner - middle).norm());
    most = std::max(most, (corner - middle).norm());
  }
  return outline.size() >= 12 && most - least < kRound * most;
}

}  // namespace

std::vector<Vec2> footprint_of(const Pose& pose, const Vec3& size) {
  std::vector<Vec2> corners;
  for (const auto& [x, y] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}})
    corners.emplace_back((pose * Vec3(x * size.x() / 2, y * size.y() / 2, 0)).head<2>());
  return corners;
}

bool hangs_high(const Node& node) { return node.pose.position.z() - node.size.z() / 2 > 1.0; }

void draw_furniture(SvgCanvas& canvas, const Node& node) {
  canvas.begin_group(node.id);
  const std::string fill = "fill=\"" + std::string(fill_of(node.archetype)) + "\"";
  if (hangs_high(node)) {
    canvas.polygon(footprint_of(node.pose, node.size),
                   fill + " fill-opacity=\"0.4\" stroke=\"#8d8573\" stroke-width=\"1\" stroke-dasharray=\"4 3\"");
  } else {
    canvas.polygon(footprint_of(node.pose, node.size), fill + " stroke=\"#7c7668\" stroke-width=\"1.2\"");
    draw_kind(canvas, node);
    draw_front(canvas, node);
  }
  canvas.end_group();
}

void draw_object(SvgCanvas& canvas, const Node& node, Simulator simulator, bool hidden) {
  std::string style = "fill=\"" + std::string(color_of(node)) + "\" stroke=\"#4d4437\" stroke-width=\"0.9\"";
  if (hidden) style += " opacity=\"0.35\"";
  canvas.begin_group(node.id);
  const std::vector<Vec2> outline = outline_of(node, simulator);
  if (outline.empty() ? is_round(node.archetype) : is_circle(outline, node.pose.position.head<2>())) {
    canvas.circle(node.pose.position.head<2>(), node.size.head<2>().minCoeff() / 2, style);
  } else {
    canvas.polygon(outline.empty() ? footprint_of(node.pose, node.size) : outline, style);
  }
  canvas.end_group();
}

}  // namespace unietp
