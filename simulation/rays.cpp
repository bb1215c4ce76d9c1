#include "simulation/rays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <embree3/rtcore.h>

#include "simulation/ray_entry.h"

namespace unietp {
namespace {

constexpr double kGrown_m = 0.002;  // thousands of times the error of single precision within a home

RayEntry enter_from_w(const RayTarget& solid, const Vec3& from, const Vec3& direction) {
  return enter(solid, solid.to_own * (from - solid.center), solid.to_own * direction);
}

/// A ray query, passed through Embree to the callback below.
struct RayQuery {
  RTCIntersectContext context;  // must be first: Embree passes its address back
  const Vec3* from = nullptr;
  const Vec3* direction = nullptr;
  double along = kNever;
  unsigned solid = 0;
  const SolidHit* after = nullptr;
};

void bounds_of_solid(const RTCBoundsFunctionArguments* asked) {
  const RayTarget& solid = static_cast<const RayTarget*>(asked->geometryUserPtr)[asked->primID];
  const Vec3 half = (solid.forms.transpose().cwiseAbs() * solid.half).array() + kGrown_m;
  const Vec3 low = solid.center - half, high = solid.center + half;
  *asked->bounds_o = {static_cast<float>(low.x()),  static_cast<float>(low.y()),  static_cast<float>(low.z()),  0,
                      static_cast<float>(high.x()), static_cast<float>(high.y()), static_cast<float>(high.z()), 0};
}

void meet_solid(const RTCIntersectFunctionNArguments* asked) {
  if (asked->valid[0] == 0) return;
  auto& question = *reinterpret_cast<RayQuery*>(asked->context);
  const RayTarget& solid = static_cast<const RayTarget*>(asked->geometryUserPtr)[asked->primID];
  const double along = enter_from_w(solid, *question.from, *question.direction).along;
  if (along > question.along || (along == question.along && asked->primID >= question.solid)) return;
  if (along == kNever) return;
  if (question.after != nullptr &&
      std::pair(along, std::size_t{asked->primID}) <= std::pair(question.after->along, question.after->solid))
    return;
  question.along = along;
  question.solid = asked->primID;
  // Farther solids are skipped, with a margin for single precision.
  auto* ray = reinterpret_cast<RTCRayHit*>(asked->rayhit);
  ray->ray.tfar = std::min(ray->ray.tfar, static_cast<float>(along * 1.001 + kGrown_m));
}

}  // namespace

struct Rays::Impl {
  std::vector<Solid> solids;
  std::vector<RayTarget> ready;
  RTCDevice device = nullptr;  // created with the first solids, since it is as slow as a view
  RTCScene scene = nullptr;

  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  std::optional<SolidHit> find(const Vec3& from, const Vec3& direction, double farthest, const SolidHit* after) const;
  ~Impl() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

Rays::Rays() : impl_(std::make_unique<Impl>()) {}
Rays::Rays(const Rays&) : Rays() {}
Rays::Rays(Rays&&) noexcept = default;
Rays& Rays::operator=(const Rays& other) {
  if (this != &other) *this = Rays(other);
  return *this;
}
Rays& Rays::operator=(Rays&&) noexcept = default;
Rays::~Rays() = default;

const std::vector<Solid>& Rays::solids() const { return impl_->solids; }

void Rays::build(std::vector<Solid> solids) {
  impl_->solids = std::move(solids);
  impl_->ready.clear();
  impl_->ready.reserve(impl_->solids.size());
  for (const Solid& solid : impl_->solids) impl_->ready.emplace_back(solid);
  if (impl_->device == nullptr) impl_->device = rtcNewDevice("threads=1,set_affinity=0");
  if (impl_->scene != nullptr) rtcReleaseScene(impl_->scene);
  impl_->scene = rtcNewScene(impl_->device);
  RTCGeometry geometry = rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(impl_->ready.size()));
  rtcSetGeometryUserData(geometry, impl_->ready.data());
  rtcSetGeometryBoundsFunction(geometry, bounds_of_solid, nullptr);
  rtcSetGeometryIntersectFunction(geometry, meet_solid);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(impl_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(impl_->scene);
}

std::optional<SolidHit> Rays::first(const Vec3& from, const Vec3& direction, double farthest) const {
  return impl_->find(from, direction, farthest, nullptr);
}

std::optional<SolidHit> Rays::next(const Vec3& from, const Vec3& direction, double farthest,
                                   const SolidHit& after) const {
  return impl_->find(from, direction, farthest, &after);
}

std::optional<SolidHit> Rays::Impl::find(const Vec3& from, const Vec3& direction, double farthest,
                                         const SolidHit* after) const {
  if (scene == nullptr) return std::nullopt;
  RayQuery question;
  question.after = after;
  rtcInitIntersectContext(&question.context);
  question.from = &from;
  question.direction = &direction;
  question.along = farthest;
  question.solid = std::numeric_limits<unsigned>::max();
  RTCRayHit ray{};
  ray.ray.org_x = static_cast<float>(from.x());
  ray.ray.org_y = static_cast<float>(from.y());
  ray.ray.org_z = static_cast<float>(from.z());
  ray.ray.dir_x = static_cast<float>(direction.x());
  ray.ray.dir_y = static_cast<float>(direction.y());
  ray.ray.dir_z = static_cast<float>(direction.z());
  ray.ray.tfar = static_cast<float>(farthest * 1.001 + kGrown_m);
  ray.ray.mask = std::numeric_limits<unsigned>::max();
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene, &question.context, &ray);
  if (question.solid == std::numeric_limits<unsigned>::max()) return std::nullopt;
  const RayTarget& solid = ready[question.solid];
  return SolidHit{question.along, question.solid, solid.normal_in_w(enter_from_w(solid, from, direction).normal)};
}

}  // namespace unietp
