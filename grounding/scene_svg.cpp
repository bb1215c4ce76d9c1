#include "grounding/scene_svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/text.h"
#include "simulation/walls.h"

namespace unietp {
namespace {

constexpr double kPixelsPerMetre = 80;
constexpr double kMargin_m = 0.5;
constexpr double kSameStop_m = 0.25;   // nearer stops are drawn as one
constexpr double kLabelFrom_m = 0.35;  // shorter pieces get no label

struct Look {
  std::string_view type, fill, ink;
};
constexpr std::array<Look, 7> kRoomLooks{{{"kitchen", "#fdf0dc", "#a8834a"},
                                          {"living_room", "#e6f0e4", "#6b8f66"},
                                          {"bedroom", "#e7e9f6", "#7078ad"},
                                          {"bathroom", "#e0f1f4", "#5f97a3"},
                                          {"dining_room", "#f8e6e2", "#b0756a"},
                                          {"office", "#f1eaf5", "#8c70a0"},
                                          {"corridor", "#f2f1ee", "#8d897f"}}};

const Look& look_of(std::string_view type) {
  const auto found = std::find_if(kRoomLooks.begin(), kRoomLooks.end(), [&](const Look& l) { return l.type == type; });
  return found == kRoomLooks.end() ? kRoomLooks.back() : *found;
}

std::string escaped(std::string_view text) {
  return replace_all(replace_all(replace_all(std::string(text), "&", "&amp;"), "<", "&lt;"), ">", "&gt;");
}

/// Two decimals are finer than a screen shows.
std::string px(double value) { return number_text(std::round(value * 100) / 100 + 0.0); }

class Drawing {
 public:
  explicit Drawing(const Scene& scene) : scene_(scene) {
    for (const Room& room : scene.rooms) {
      for (const Vec2& corner : room.polygon) {
        low_ = low_.cwiseMin(corner);
        high_ = high_.cwiseMax(corner);
      }
    }
    if (scene.rooms.empty()) low_ = high_ = Vec2::Zero();
    low_ -= Vec2::Constant(kMargin_m);
    high_ += Vec2::Constant(kMargin_m);
  }

  std::string finish(const std::vector<std::vector<Vec2>>& legs) {
    const Vec2 size = (high_ - low_) * kPixelsPerMetre;
    svg_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + px(size.x()) + "\" height=\"" + px(size.y()) +
           "\" viewBox=\"0 0 " + px(size.x()) + " " + px(size.y()) +
           "\" font-family=\"Helvetica, Arial, sans-serif\">\n<title>" + escaped(scene_.id) + "</title>\n" +
           "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
    rooms();
    std::vector<const Node*> furniture, movable;
    for (const Node& node : scene_.nodes) (node.movable ? movable : furniture).push_back(&node);
    // High things are drawn over what they stand on or hang above.
    std::stable_sort(furniture.begin(), furniture.end(),
                     [](const Node* a, const Node* b) { return a->pose.position.z() < b->pose.position.z(); });
    for (const Node* node : furniture) piece(*node);
    walls();
    names();
    for (const Node* node : movable) dot(*node);
    if (!legs.empty()) walk(legs);
    agent();
    return svg_ + "</svg>\n";
  }

 private:
  Vec2 at(const Vec2& point) const {
    return {(point.x() - low_.x()) * kPixelsPerMetre, (high_.y() - point.y()) * kPixelsPerMetre};
  }
  std::string xy(const Vec2& point) const {
    const Vec2 p = at(point);
    return px(p.x()) + "," + px(p.y());
  }
  void text(const Vec2& point, double size, std::string_view fill, std::string_view weight, const std::string& words) {
    const Vec2 p = at(point);
    svg_ += "<text x=\"" + px(p.x()) + "\" y=\"" + px(p.y()) + "\" font-size=\"" + px(size) + "\" font-weight=\"" +
            std::string(weight) + "\" text-anchor=\"middle\" dominant-baseline=\"middle\" fill=\"" + std::string(fill) +
            "\">" + escaped(words) + "</text>\n";
  }
  void polygon(const std::vector<Vec2>& corners, const std::string& style) {
    svg_ += "<polygon points=\"";
    for (const Vec2& corner : corners) svg_ += xy(corner) + " ";
    svg_.back() = '"';
    svg_ += " " + style + "/>\n";
  }
  static std::vector<Vec2> corners_of(const Pose& pose, const Vec3& size) {
    std::vector<Vec2> corners;
    for (const auto& [x, y] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
      corners.emplace_back((pose * Vec3(x * size.x() / 2, y * size.y() / 2, 0)).head<2>());
    }
    return corners;
  }

  void rooms() {
    for (const Room& room : scene_.rooms) {
      const Look& look = look_of(room.type);
      polygon(room.polygon, "fill=\"" + std::string(look.fill) + "\"");
    }
  }
  void names() {
    for (const Room& room : scene_.rooms) {
      Vec2 low = room.polygon.front(), high = low;
      for (const Vec2& corner : room.polygon) {
        low = low.cwiseMin(corner);
        high = high.cwiseMax(corner);
      }
      text((low + high) / 2, 17, look_of(room.type).ink, "600", replace_all(room.id, "_", " "));
    }
  }
  void walls() {
    for (const WallPiece& wall : walls_of(scene_)) {
      const bool lintel = wall.pose.position.z() - wall.size.z() / 2 > 0.1;
      if (!lintel) polygon(corners_of(wall.pose, wall.size), "fill=\"#4b4a48\"");
    }
  }
  void piece(const Node& node) {
    const bool high_up = node.pose.position.z() - node.size.z() / 2 > 1.0;
    polygon(corners_of(node.pose, node.size),
            std::string("fill=\"#ffffff\" fill-opacity=\"") + (high_up ? "0.35" : "0.8") +
                "\" stroke=\"#8a8780\" stroke-width=\"1.2\"" + (high_up ? " stroke-dasharray=\"4 3\"" : "") + "");
    const Vec3 half = node.size / 2;
    if (node.openable) {
      const Vec2 a = at((node.pose * Vec3(-half.x() * 0.7, -half.y(), 0)).head<2>());
      const Vec2 b = at((node.pose * Vec3(half.x() * 0.7, -half.y(), 0)).head<2>());
      svg_ += "<line x1=\"" + px(a.x()) + "\" y1=\"" + px(a.y()) + "\" x2=\"" + px(b.x()) + "\" y2=\"" + px(b.y()) +
              "\" stroke=\"#b0683c\" stroke-width=\"3\"/>\n";
    }
    if (node.size.head<2>().maxCoeff() < kLabelFrom_m || high_up) return;
    const Bounds bounds = bounds_of(node.pose, node.size);
    const double width_px = (bounds.high.x() - bounds.low.x()) * kPixelsPerMetre;
    const double size = std::clamp(1.7 * width_px / static_cast<double>(node.id.size()), 6.0, 10.0);
    if (width_px < 5.0 * static_cast<double>(node.id.size()) * 0.6) return;
    text(node.pose.position.head<2>(), size, "#5d5a55", "400", node.id);
  }
  void dot(const Node& node) {
    const Vec2 p = at(node.pose.position.head<2>());
    const double radius = std::clamp(node.size.head<2>().mean() / 2 * kPixelsPerMetre, 2.5, 9.0);
    svg_ += "<circle cx=\"" + px(p.x()) + "\" cy=\"" + px(p.y()) + "\" r=\"" + px(radius) +
            "\" fill=\"#d98032\" fill-opacity=\"0.75\" stroke=\"#8a4d16\" stroke-width=\"0.8\"><title>" +
            escaped(node.id) + "</title></circle>\n";
  }
  void agent() {
    const auto corner = [&](double angle, double length) {
      const double a = scene_.agent.yaw + angle;
      return Vec2(scene_.agent.position + length * Vec2(std::cos(a), std::sin(a)));
    };
    polygon({corner(0, 0.26), corner(2.5, 0.22), corner(-2.5, 0.22)},
            "fill=\"#2f6fb2\" stroke=\"#173b61\" stroke-width=\"1.5\" stroke-linejoin=\"round\"");
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
      svg_ += "<polyline points=\"";
      for (const Vec2& point : legs[i]) svg_ += xy(point) + " ";
      svg_.back() = '"';
      svg_ +=
          " fill=\"none\" stroke=\"#2f6fb2\" stroke-width=\"2.5\" stroke-dasharray=\"7 4\" "
          "stroke-linejoin=\"round\"/>\n";
      stop_at(legs[i].back(), i + 2);
    }
    for (const Stop& stop : stops) {
      const Vec2 p = at(stop.at);
      const double half_width = 5.0 + 4.0 * static_cast<double>(stop.numbers.size());
      svg_ += "<rect x=\"" + px(p.x() - half_width) + "\" y=\"" + px(p.y() - 9) + "\" width=\"" + px(2 * half_width) +
              "\" height=\"18\" rx=\"9\" fill=\"#ffffff\" stroke=\"#2f6fb2\" stroke-width=\"2\"/>\n";
      text(stop.at, 10, "#173b61", "700", stop.numbers);
    }
  }

  const Scene& scene_;
  Vec2 low_ = Vec2::Constant(1e9), high_ = Vec2::Constant(-1e9);
  std::string svg_;
};

}  // namespace

std::string scene_svg(const Scene& scene, const std::vector<std::vector<Vec2>>& legs) {
  return Drawing(scene).finish(legs);
}

}  // namespace unietp
