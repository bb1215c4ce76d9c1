#include "simulation/spots.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace unietp {
namespace {

constexpr double kLetGo_m = 0.002;     // objects are released this far above the surface
constexpr double kSpotPitch_m = 0.05;  // pitch of the grid of spots
constexpr double kEasyHeight_m = 1.0;  // shelves near this height are tried first

/// Orientations of an object: upright along the surface's axes, or lying when it is too tall.
std::vector<Quat> orientations(double clearance, const Vec3& size, bool alone) {
  const auto turn = [](double angle, const Vec3& axis) { return Quat(Eigen::AngleAxisd(angle, axis)); };
  constexpr double kQuarter = std::numbers::pi / 2;
  if (size.z() + kLetGo_m <= clearance) return {Quat::Identity(), turn(kQuarter, Vec3::UnitZ())};
  if (!alone) return {};
  std::vector<Quat> lying;
  if (size.y() + kLetGo_m <= clearance) lying.push_back(turn(kQuarter, Vec3::UnitX()));
  if (size.x() + kLetGo_m <= clearance) lying.push_back(turn(kQuarter, Vec3::UnitY()));
  const std::size_t ways = lying.size();
  for (std::size_t i = 0; i < ways; ++i) lying.push_back(turn(kQuarter, Vec3::UnitZ()) * lying[i]);
  return lying;
}

double above_arm(const Vec3& spot, const Profile& profile) { return std::max(0.0, spot.z() - profile.body_height_m); }

}  // namespace

SurfaceFit for_each_spot(const Node& receptacle, const Shape& shape, const Vec3& size, bool inside, bool alone,
                         const std::function<bool(const Pose&)>& visit) {
  SurfaceFit offer;
  for (const Surface& surface : shape.surfaces) {
    if ((surface.cavity >= 0) != inside) continue;
    offer.any_surface = true;
    const Pose frame = receptacle.pose * joint_motion(shape, surface.joint, receptacle.opening);
    for (const Quat& orientation : orientations(surface.clearance, size, alone)) {
      const Bounds extent = bounds_of({Vec3::Zero(), orientation}, size);
      const Vec2 room = surface.half - extent.high.head<2>();
      // In a cavity an object must fit completely; on a surface its center must be inside the edge.
      if (inside && room.minCoeff() < -1e-6) continue;
      if (!inside && (surface.half - 0.6 * extent.high.head<2>()).minCoeff() < 0) continue;
      offer.any_fit = true;
      const auto steps = [](double free) { return std::max(0, static_cast<int>(std::floor(free / kSpotPitch_m))); };
      const int nx = steps(room.x()), ny = steps(room.y());
      for (int i = -nx; i <= nx; ++i) {
        for (int k = -ny; k <= ny; ++k) {
          const Vec3 local = surface.center + Vec3(i * kSpotPitch_m, k * kSpotPitch_m, extent.high.z() + kLetGo_m);
          if (!visit(frame * Pose{local, orientation})) return offer;
        }
      }
    }
  }
  return offer;
}

double arm_length(const Vec3& spot, const Vec2& at, const Profile& profile) {
  const double flat = (spot.head<2>() - at).norm(), above = above_arm(spot, profile);
  return above == 0 ? flat : std::hypot(flat, above);  // the same, sooner for nearly all spots
}

double effort(const Vec3& spot, double arm) { return std::hypot(arm, spot.z() - kEasyHeight_m); }

}  // namespace unietp
