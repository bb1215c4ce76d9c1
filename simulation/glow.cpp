#include "simulation/glow.h"

#include <algorithm>
#include <cmath>

#include "simulation/noise.h"

namespace unietp {
namespace {

double strength_of(Device device) {
  switch (device) {
    case Device::Lamp:
      return 0.75;
    case Device::Flame:
      return 0.3;
    case Device::Screen:
    case Device::Burner:
      return 0.15;
    default:
      return 0;
  }
}

}  // namespace

std::vector<LightSource> light_sources(const Scene& scene, const std::vector<Look>& looks, const Camera& camera,
                                       double farthest) {
  std::vector<LightSource> sources;
  for (std::size_t i = 0; i < looks.size(); ++i) {
    const double strength = looks[i].on ? strength_of(looks[i].device) : 0;
    if (strength <= 0) continue;
    const Vec3 at = scene.nodes[i].pose * Vec3(0, 0, 0.6 * looks[i].half.z());
    if ((at - camera.at).norm() > farthest) continue;
    sources.push_back({at, strength, room_at(scene, at.head<2>())});
  }
  return sources;
}

Vec3 light_of(const std::vector<LightSource>& sources, const Vec3& at, const Vec3& normal) {
  constexpr double kHalf_m = 0.7, kAround = 0.35;  // half as strong at this distance; on faces turned away
  double sum = 0;
  for (const LightSource& source : sources) {
    if (source.room != nullptr && !contains(source.room->polygon, at.head<2>())) continue;
    const Vec3 way = source.at - at;
    const double far = way.squaredNorm();
    const double facing = std::max(kAround, normal.dot(way) / std::sqrt(std::max(far, 1e-9)));
    sum += source.strength * facing / (1 + far / (kHalf_m * kHalf_m));
  }
  return sum * Vec3(1, 0.84, 0.56);
}

std::vector<Puff> puffs_of(const Node& node, const Look& look) {
  std::vector<Puff> puffs;
  const double reach = look.half.maxCoeff();
  if (look.on && strength_of(look.device) > 0.2) {
    const double wide = std::clamp(2.4 * reach, 0.12, 0.5);
    const Vec3 middle(0, 0, look.device == Device::Flame ? look.half.z() + 0.03 : 0.5 * look.half.z());
    puffs.push_back({node.pose * middle, wide, {255, 226, 150}, 0.55});
  }
  if (!look.hot) return puffs;
  constexpr int kPuffs = 9;
  const double wide = std::clamp(0.55 * look.half.head<2>().maxCoeff(), 0.022, 0.09);
  const Vec3 top = node.pose.position + Vec3(0, 0, look.half.z());
  for (int i = 0; i < kPuffs; ++i) {
    const double aside = 1.6 * wide * (hashed(i, 0, 0, look.seed) - 0.5), deep = hashed(i, 1, 0, look.seed) - 0.5;
    const Vec3 at = top + Vec3(aside, wide * deep, 0.62 * wide * i);
    puffs.push_back({at, wide * (0.7 + 0.08 * i), {250, 250, 252}, 0.6 - 0.045 * i});
  }
  return puffs;
}

}  // namespace unietp
