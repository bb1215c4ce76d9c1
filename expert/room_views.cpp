#include "expert/room_views.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace unietp {
namespace {

constexpr int kPointsAcross = 6;
constexpr double kOnTheEdge = 1e-9;  // of the picture: in it, however it is rounded
constexpr double kThere_m = 1e-6;
constexpr double kUnderfoot_m = 0.3;  // what is under the feet is not looked at

/// Points over a room's floor, and its middle where they miss it.
std::vector<Vec2> points_in(const Room& room, const Vec2& middle) {
  const Bounds bounds = room_bounds(room, 1);
  const Vec2 low = bounds.low.head<2>(), span = bounds.high.head<2>() - low;
  std::vector<Vec2> points;
  for (int i = 0; i < kPointsAcross; ++i) {
    for (int j = 0; j < kPointsAcross; ++j) {
      const Vec2 point = low + span.cwiseProduct(Vec2(i + 0.5, j + 0.5) / kPointsAcross);
      if (contains(room.polygon, point)) points.push_back(point);
    }
  }
  if (points.empty()) points.push_back(middle);
  return points;
}

Vec2 unit(double yaw) { return {std::cos(yaw), std::sin(yaw)}; }

}  // namespace

RoomViews::RoomViews(const Scene& home, const Profile& profile) : turn_(profile.turn_deg * std::numbers::pi / 180) {
  const double half_height = std::tan(profile.vertical_fov_deg * std::numbers::pi / 360);
  narrowest_ = std::cos(std::atan(half_height * profile.image_width / profile.image_height)) - kOnTheEdge;
  for (const Room& room : home.rooms) {
    Seen& seen = rooms_.emplace_back();
    seen.room = &room;
    for (const Vec2& corner : room.polygon) seen.middle += corner / static_cast<double>(room.polygon.size());
    seen.unseen = points_in(room, seen.middle);
    seen.all = seen.unseen.size();
  }
}

bool RoomViews::shows(const Vec2& ahead, const Vec2& way, double away) const {
  return away >= kUnderfoot_m && ahead.dot(way) >= narrowest_ * away;
}

void RoomViews::saw(const Agent& body) {
  const Vec2 ahead = unit(body.yaw);
  for (Seen& seen : rooms_) {
    if (!contains(seen.room->polygon, body.position)) continue;
    std::erase_if(seen.unseen, [&](const Vec2& point) {
      const Vec2 way = point - body.position;
      const double away = way.norm();
      return away < kUnderfoot_m || shows(ahead, way, away);
    });
  }
}

double RoomViews::unseen(std::size_t room) const {
  return static_cast<double>(rooms_[room].unseen.size()) / static_cast<double>(rooms_[room].all);
}

std::optional<RoomViews::Look> RoomViews::best(std::size_t room, const Agent& body) const {
  const Seen& seen = rooms_[room];
  if (seen.unseen.empty()) return std::nullopt;
  const int half_round = static_cast<int>(std::lround(std::numbers::pi / turn_));
  std::optional<Look> best;
  std::vector<Vec2> ways(seen.unseen.size());
  std::vector<double> away(seen.unseen.size());
  const auto offer = [&](Look look) {
    const Vec2 ahead = unit(body.yaw + look.turns * turn_);
    int shown = 0;
    for (std::size_t i = 0; i < ways.size(); ++i) shown += shows(ahead, ways[i], away[i]) ? 1 : 0;
    look.shows = static_cast<double>(shown) / static_cast<double>(seen.all);
    if (shown > 0 && (!best || look.shows / look.steps() > best->shows / best->steps())) best = look;
  };
  for (const bool goes : {false, true}) {
    const bool is_there = (body.position - seen.middle).norm() < kThere_m;
    if (goes ? is_there : !contains(seen.room->polygon, body.position)) continue;
    const Vec2 from = goes ? seen.middle : body.position;
    for (std::size_t i = 0; i < ways.size(); ++i) {
      ways[i] = seen.unseen[i] - from;
      away[i] = ways[i].norm();
    }
    for (int turns = goes ? 0 : 1; turns <= half_round; ++turns) {
      offer({goes, turns});
      if (turns > 0) offer({goes, -turns});
    }
  }
  return best;
}

}  // namespace unietp
