#include "grounding/scene_svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/text.h"
#include "grounding/label_layout.h"
#include "grounding/node_drawing.h"
#include "grounding/svg_canvas.h"
#include "simulation/walls.h"

namespace unietp {
namespace {

constexpr double kMargin_m = 0.5, kFoot_m = 0.45;  // the foot has the scale and the numbers
constexpr double kSameStop_m = 0.25;               // nearer stops are drawn as one
constexpr double kLabelFrom_m = 0.3;               // shorter pieces get no label
constexpr double kRoomLabelGrid_m = 0.3;

struct Look {
  std::string_view type, fill, ink;
};
constexpr std::array<Look, 8> kRoomLooks{{{"kitchen", "#fdf3e2", "#8a6526"},
                                          {"living_room", "#ecf4ea", "#4d7548"},
                                          {"bedroom", "#eeeff9", "#545d99"},
                                          {"bathroom", "#e7f4f6", "#3f7c8a"},
                                          {"dining_room", "#faeeeb", "#96584c"},
                                          {"office", "#f5f0f8", "#725588"},
                                          {"garden", "#e9f3df", "#5c7a38"},
                                          {"corridor", "#f5f4f1", "#6f6b62"}}};

const Look& look_of(std::string_view type) {
  const auto found = std::find_if(kRoomLooks.begin(), kRoomLooks.end(), [&](const Look& l) { return l.type == type; });
  return found == kRoomLooks.end() ? kRoomLooks.back() : *found;
}

std::string words_of_id(std::string_view id) { return replace_all(std::string(id), "_", " "); }

bool inside_polygon(const std::vector<Vec2>& polygon, const Vec2& point) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2 &a = polygon[i], &b = polygon[j];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    if (point.x() < (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()) + a.x()) inside = !inside;
  }
  return inside;
}

struct Extent {
  Vec2 low = Vec2::Constant(1e9), high = Vec2::Constant(-1e9);
  void add(const Vec2& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
};

Extent extent_of(const std::vector<Vec2>& points) {
  Extent extent;
  for (const Vec2& point : points) extent.add(point);
  return extent;
}

/// What the picture shows: the rooms, or where there are none whatever stands there.
Extent extent_of(const Scene& scene) {
  Extent extent;
  for (const Room& room : scene.rooms) {
    for (const Vec2& corner : room.polygon) extent.add(corner);
  }
  for (const Node& node : scene.nodes) {
    for (const Vec2& corner : footprint_of(node.pose, node.size)) extent.add(corner);
  }
  extent.add(scene.agent.position);
  extent.low -= Vec2(kMargin_m, kMargin_m + kFoot_m);
  extent.high += Vec2::Constant(kMargin_m);
  return extent;
}

class Drawing {
 public:
  explicit Drawing(const Scene& scene)
      : scene_(scene), extent_(extent_of(scene)), canvas_(extent_.low, extent_.high, scene.id) {}

  std::string finish(const std::vector<std::vector<Vec2>>& legs) && {
    for (const Room& room : scene_.rooms)
      canvas_.polygon(room.polygon, "fill=\"" + std::string(look_of(room.type).fill) + "\"");
    std::vector<const Node*> furniture, movable;
    for (const Node& node : scene_.nodes) (node.movable ? movable : furniture).push_back(&node);
    // High things are drawn over what they stand on or hang above.
    const auto lower = [](const Node* a, const Node* b) { return a->pose.position.z() < b->pose.position.z(); };
    std::stable_sort(furniture.begin(), furniture.end(), lower);
    std::stable_sort(movable.begin(), movable.end(), lower);
    for (const Node* node : furniture) draw_furniture(canvas_, *node);
    walls();
    const std::set<std::string> hidden = hidden_things();
    for (const Node* node : movable) draw_object(canvas_, *node, scene_.simulator, hidden.contains(node->id));
    if (!legs.empty()) walk(legs);
    agent();
    labels(furniture, movable);
    foot(furniture.size(), movable.size());
    return std::move(canvas_).finish();
  }

 private:
  void walls() {
    for (const WallPiece& wall : walls_of(scene_)) {
      const bool lintel = wall.pose.position.z() - wall.size.z() / 2 > 0.1;
      if (!lintel) canvas_.polygon(footprint_of(wall.pose, wall.size), "fill=\"#4b4a48\"");
    }
    for (const Opening& opening : scene_.openings)
      canvas_.line({opening.from, opening.to}, "stroke=\"#b8b3a8\" stroke-width=\"1.4\" stroke-dasharray=\"3 3\"");
  }

  /// Things in closed furniture, and what is in those things.
  std::set<std::string> hidden_things() const {
    std::set<std::string> closed, hidden;
    for (const Node& node : scene_.nodes) {
      if (node.openable && node.opening <= 0) closed.insert(node.id);
    }
    for (const Edge& edge : scene_.edges) {
      if (edge.relation == Predicate::Inside && closed.contains(edge.to)) hidden.insert(edge.from);
    }
    return hidden;
  }

  LabelBox box_of(const std::vector<Vec2>& corners) const {
    const Extent extent = extent_of(corners);
    const Vec2 a = canvas_.pixels(extent.low), b = canvas_.pixels(extent.high);
    return {(a + b) / 2, (a - b).cwiseAbs()};
  }

  /// Anywhere in the room, from its middle outwards.
  Label label_of(const Room& room) const {
    const Extent extent = extent_of(room.polygon);
    const Vec2 middle = (extent.low + extent.high) / 2;
    std::vector<Vec2> points;
    for (double x = extent.low.x() + kRoomLabelGrid_m; x < extent.high.x(); x += kRoomLabelGrid_m) {
      for (double y = extent.low.y() + kRoomLabelGrid_m; y < extent.high.y(); y += kRoomLabelGrid_m)
        points.emplace_back(x, y);
    }
    std::stable_sort(points.begin(), points.end(), [&](const Vec2& a, const Vec2& b) {
      return (a - middle).squaredNorm() < (b - middle).squaredNorm();
    });
    Label label{words_of_id(room.id), {17, 14, 11, 9}, {}, 1e9};
    for (const Vec2& point : points) {
      if (inside_polygon(room.polygon, point)) label.centers_px.push_back(canvas_.pixels(point));
    }
    return label;
  }

  /// On the piece, where it is clear of what stands there; else beside it, where nothing is.
  Label label_of(const Node& node, const std::vector<LabelBox>& solid) const {
    const LabelBox box = box_of(footprint_of(node.pose, node.size));
    Label label{words_of_id(node.id), {9.5, 8, 6.5}, {}, 1};
    const Vec2 least = text_extent_px(label.words, label.sizes_px.back());
    if (least.x() < box.size.x() && least.y() < box.size.y()) {
      std::erase_if(label.sizes_px,
                    [&](double size) { return text_extent_px(label.words, size).x() > box.size.x() + 2; });
      for (const double y : {0.0, -0.25, 0.25, -0.4, 0.4})
        label.centers_px.emplace_back(box.center.x(), box.center.y() + y * (box.size.y() - least.y()));
      return label;
    }
    label.sizes_px = {8, 6.5};
    for (const double side : {1.0, -1.0}) {
      const LabelBox beside{box.center + Vec2(0, side * (box.size.y() / 2 + 6)), text_extent_px(label.words, 8)};
      const auto covers = [&](const LabelBox& other) { return overlap(beside, other); };
      if (std::none_of(solid.begin(), solid.end(), covers)) label.centers_px.push_back(beside.center);
    }
    return label;
  }

  void labels(const std::vector<const Node*>& furniture, const std::vector<const Node*>& movable) {
    std::vector<LabelBox> loose, solid;
    for (const Node* node : movable) loose.push_back(box_of(footprint_of(node->pose, node->size)));
    loose.push_back({canvas_.pixels(scene_.agent.position), Vec2(30, 30)});
    for (const WallPiece& wall : walls_of(scene_)) solid.push_back(box_of(footprint_of(wall.pose, wall.size)));
    for (const Node* node : furniture) {
      if (!hangs_high(*node)) solid.push_back(box_of(footprint_of(node->pose, node->size)));
    }
    // Rooms keep clear of everything; the names of furniture stand on it and keep clear of what is loose.
    std::vector<LabelBox> everything = loose;
    everything.insert(everything.end(), solid.begin(), solid.end());
    std::vector<Label> names;
    for (const Room& room : scene_.rooms) names.push_back(label_of(room));
    const auto rooms = place_labels(names, everything);
    for (std::size_t i = 0; i < rooms.size(); ++i) {
      if (!rooms[i]) continue;
      const std::string ink(look_of(scene_.rooms[i].type).ink);
      write(names[i].words, *rooms[i], "fill=\"" + ink + "\" font-weight=\"600\"");
      names[i] = {names[i].words, {rooms[i]->size_px}, {rooms[i]->center_px}, 1e9};  // stays where it is
    }
    std::vector<const Node*> largest = furniture;
    std::stable_sort(largest.begin(), largest.end(),
                     [](const Node* a, const Node* b) { return a->size.head<2>().prod() > b->size.head<2>().prod(); });
    for (const Node* node : largest) {
      const bool plain = node->size.head<2>().maxCoeff() < kLabelFrom_m || node->archetype == Archetype::Panel;
      if (!plain && !hangs_high(*node)) names.push_back(label_of(*node, solid));
    }
    const auto placed = place_labels(names, loose);
    for (std::size_t i = rooms.size(); i < placed.size(); ++i) {
      if (placed[i]) write(names[i].words, *placed[i], "fill=\"#4c473d\"");
    }
  }

  void write(const std::string& words, const PlacedLabel& place, const std::string& style) {
    const Vec2 meters = place.center_px / SvgCanvas::kPixelsPerMeter;
    canvas_.text({extent_.low.x() + meters.x(), extent_.high.y() - meters.y()}, place.size_px, style, words);
  }

  void agent() {
    const auto corner = [&](double angle, double length) {
      const double a = scene_.agent.yaw + angle;
      return Vec2(scene_.agent.position + length * Vec2(std::cos(a), std::sin(a)));
    };
    canvas_.begin_group("agent");
    canvas_.polygon({corner(0, 0.26), corner(2.5, 0.22), corner(-2.5, 0.22)},
                    "fill=\"#2f6fb2\" stroke=\"#173b61\" stroke-width=\"1.5\" stroke-linejoin=\"round\"");
    canvas_.end_group();
  }

  void walk(const std::vector<std::vector<Vec2>>& legs) {
    struct Stop {
      Vec2 at;
      std::string numbers;
    };
    std::vector<Stop> stops;
    const auto stop_at = [&](const Vec2& point, std::size_t number) {
      const auto known = std::find_if(stops.begin(), stops.end(),
                                      [&](const Stop& stop) { return (stop.at - point).norm() < kSameStop_m; });
      if (known == stops.end()) {
        stops.push_back({point, std::to_string(number)});
      } else {
        known->numbers.append(",").append(std::to_string(number));
      }
    };
    stop_at(legs.front().front(), 1);
    for (std::size_t i = 0; i < legs.size(); ++i) {
      canvas_.line(legs[i], "class=\"leg\" stroke=\"#2f6fb2\" stroke-width=\"2.5\" stroke-dasharray=\"7 4\"");
      stop_at(legs[i].back(), i + 2);
    }
    for (const Stop& stop : stops) {
      canvas_.pill(stop.at, {10.0 + 8.0 * static_cast<double>(stop.numbers.size()), 18},
                   "fill=\"#ffffff\" stroke=\"#2f6fb2\" stroke-width=\"2\"");
      canvas_.text(stop.at, 10, "fill=\"#173b61\" font-weight=\"700\"", stop.numbers);
    }
  }

  /// A meter to measure by, and how much there is.
  void foot(std::size_t furniture, std::size_t objects) {
    const Vec2 left(extent_.low.x() + kMargin_m, extent_.low.y() + kFoot_m);
    constexpr std::string_view kInk = "stroke=\"#6f6b62\" stroke-width=\"1.4\"";
    canvas_.line({left, left + Vec2(1, 0)}, kInk);
    for (const double x : {0.0, 1.0}) canvas_.line({left + Vec2(x, -0.06), left + Vec2(x, 0.06)}, kInk);
    canvas_.text(left + Vec2(0.5, -0.18), 10, "fill=\"#6f6b62\"", "1 m");
    const std::string summary = scene_.id + ": " + std::to_string(scene_.rooms.size()) + " rooms, " +
                                std::to_string(furniture) + " pieces of furniture, " + std::to_string(objects) +
                                " objects";
    const double half_m = text_extent_px(summary, 11).x() / 2 / SvgCanvas::kPixelsPerMeter;
    canvas_.text(left + Vec2(1.3 + half_m, -0.02), 11, "fill=\"#6f6b62\"", summary);
  }

  const Scene& scene_;
  Extent extent_;
  SvgCanvas canvas_;
};

}  // namespace

std::string scene_svg(const Scene& scene, const std::vector<std::vector<Vec2>>& legs) {
  return Drawing(scene).finish(legs);
}

}  // namespace unietp
