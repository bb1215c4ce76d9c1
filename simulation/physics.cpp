#include "simulation/physics.h"

#include <algorithm>
#include <array>
#include <string>
#include <unordered_map>

#include "core/shared_list.h"
#include "simulation/body_grid.h"
#include "simulation/settle.h"
#include "simulation/touch.h"

namespace unietp {
namespace {

struct Body {
  std::shared_ptr<const Collider> collider;  // nullptr: no such body. Shared by bodies of equal shape.
  Pose pose;
  double mass = 0;
  Bounds bounds;
  mutable std::shared_ptr<const std::vector<Convex>> placed;  // computed on demand; shared by copies
  const std::vector<Convex>& parts() const {
    if (placed == nullptr) placed = std::make_shared<const std::vector<Convex>>(collider->placed(pose));
    return *placed;
  }
};

Bounds merged(const Bounds& a, const Bounds& b) { return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)}; }

Bounds lowered(Bounds bounds, double by) {
  bounds.low.z() -= by;
  bounds.high.z() -= by;
  return bounds;
}

/// Of the contacts between the solids the one whose normal points most upwards.
std::optional<Touch> most_upward(const std::vector<Convex>& solids, const Body& other, double depth) {
  std::optional<Touch> best;
  for (const Convex& solid : solids) {
    if (!overlap(solid.bounds, other.bounds)) continue;
    for (const Convex& part : other.parts()) {
      const auto touching = touch(solid, part);
      if (!touching || touching->depth < depth) continue;
      if (!best || touching->normal.z() > best->normal.z()) best = touching;
    }
  }
  return best;
}

bool any_touch(const std::vector<Convex>& solids, const Body& other, double depth) {
  for (const Convex& solid : solids) {
    if (!overlap(solid.bounds, other.bounds)) continue;
    for (const Convex& part : other.parts()) {
      const auto touching = touch(solid, part);
      if (touching && touching->depth >= depth) return true;
    }
  }
  return false;
}

void append(std::string& bytes, const void* from, std::size_t size) {
  bytes.append(static_cast<const char*>(from), size);
}

void append(std::string& bytes, const Body& body) {
  append(bytes, &body.collider->digest, sizeof(Digest));
  append(bytes, body.pose.position.data(), 3 * sizeof(double));
  append(bytes, body.pose.rotation.coeffs().data(), 4 * sizeof(double));
  append(bytes, &body.mass, sizeof(double));
}

}  // namespace

struct PhysicsWorld::Impl {
  SharedList<Body> things, walls;
  std::shared_ptr<const RoomFinder> floor = std::make_shared<RoomFinder>();
  mutable std::optional<BodyGrid> grid;  // built by the first query
  // Cache of settling results, since variants of a plan repeat the same placements.
  mutable std::unordered_map<std::string, Rest> settled;

  SharedList<Body>& list_of(BodyId id) { return id.is_node() ? things : walls; }

  const Body* find(BodyId id) const {
    const auto& list = id.is_node() ? things : walls;
    const std::size_t place = id.index();
    return place < list.size() && list[place].collider != nullptr ? &list[place] : nullptr;
  }
  const Body& at(BodyId id) const { return *find(id); }

  template <class Visit>
  void each(Visit visit) const {
    for (std::size_t i = 0; i < things.size(); ++i) {
      if (things[i].collider != nullptr) visit(BodyId::node(i), things[i]);
    }
    for (std::size_t i = 0; i < walls.size(); ++i) {
      if (walls[i].collider != nullptr) visit(BodyId::wall(i), walls[i]);
    }
  }

  const BodyGrid& ask() const {
    if (!grid) {
      std::optional<Bounds> around;
      each([&](BodyId, const Body& body) { around = around ? merged(*around, body.bounds) : body.bounds; });
      grid.emplace(around.value_or(Bounds{}));
      each([&](BodyId id, const Body& body) { grid->insert(id.number(), body.bounds); });
    }
    return *grid;
  }

  std::vector<BodyId> near(const Bounds& bounds, double gap) const {
    constexpr std::size_t kUsual = 32;
    std::vector<BodyId> ids;
    ids.reserve(kUsual);
    const Vec3 grown = Vec3::Constant(gap);
    ask().visit({bounds.low - grown, bounds.high + grown}, [&](std::uint32_t number) {
      const auto id = BodyId::from_number(number);
      if (unietp::overlap(at(id).bounds, bounds, gap)) ids.push_back(id);
    });
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    return ids;
  }
};

PhysicsWorld::PhysicsWorld() : impl_(std::make_unique<Impl>()) {}
PhysicsWorld::PhysicsWorld(const PhysicsWorld& other) : impl_(std::make_unique<Impl>()) {
  impl_->things = other.impl_->things;
  impl_->walls = other.impl_->walls;
  impl_->floor = other.impl_->floor;
  impl_->grid = other.impl_->grid;
}
PhysicsWorld::PhysicsWorld(PhysicsWorld&&) noexcept = default;
PhysicsWorld& PhysicsWorld::operator=(const PhysicsWorld& other) {
  if (this != &other) *this = PhysicsWorld(other);
  return *this;
}
PhysicsWorld& PhysicsWorld::operator=(PhysicsWorld&&) noexcept = default;
PhysicsWorld::~PhysicsWorld() = default;

void PhysicsWorld::divide_floor(const std::vector<Room>& rooms) {
  impl_->floor = std::make_shared<const RoomFinder>(rooms);
}

const RoomFinder& PhysicsWorld::floor() const { return *impl_->floor; }

void PhysicsWorld::prepare() {
  impl_->ask();
  impl_->each([](BodyId, const Body& body) { body.parts(); });
}

void PhysicsWorld::set(BodyId id, std::shared_ptr<const Collider> collider, const Pose& pose, double mass) {
  remove(id);
  auto& list = impl_->list_of(id);
  const std::size_t place = id.index();
  while (place >= list.size()) list.emplace_back();
  const Bounds bounds = collider->bounds(pose);
  list.edit(place) = {std::move(collider), pose, mass, bounds, nullptr};
  if (impl_->grid) impl_->grid->insert(id.number(), bounds);
}

void PhysicsWorld::set(BodyId id, const Shape& shape, const Pose& pose, double opening, double mass) {
  set(id, std::make_shared<const Collider>(shape, opening), pose, mass);
}

void PhysicsWorld::move(BodyId id, const Pose& pose) {
  Body& body = impl_->list_of(id).edit(id.index());
  if (impl_->grid) impl_->grid->erase(id.number(), body.bounds);
  body.pose = pose;
  body.bounds = body.collider->bounds(pose);
  body.placed.reset();
  if (impl_->grid) impl_->grid->insert(id.number(), body.bounds);
}

void PhysicsWorld::remove(BodyId id) {
  const Body* body = impl_->find(id);
  if (body == nullptr) return;
  if (impl_->grid) impl_->grid->erase(id.number(), body->bounds);
  impl_->list_of(id).edit(id.index()) = {};
}

bool PhysicsWorld::has(BodyId id) const { return impl_->find(id) != nullptr; }

const Collider& PhysicsWorld::collider(BodyId id) const { return *impl_->at(id).collider; }

std::shared_ptr<const Collider> PhysicsWorld::share(BodyId id) const { return impl_->at(id).collider; }

Bounds PhysicsWorld::bounds(BodyId id) const { return impl_->at(id).bounds; }

std::vector<Contact> PhysicsWorld::contacts(BodyId id, double gap) const {
  const Body& body = impl_->at(id);
  std::vector<Convex> sunk = body.parts();
  for (Convex& part : sunk) {
    part.center.z() -= gap;
    part.bounds = lowered(part.bounds, gap);
  }
  std::vector<Contact> all;
  for (const BodyId other : impl_->near(lowered(body.bounds, gap), 0)) {
    if (other == id) continue;
    if (const auto touching = most_upward(sunk, impl_->at(other), 0)) {
      all.push_back({other, touching->normal, gap - touching->depth});
    }
  }
  const double above_floor = body.bounds.low.z();
  if (above_floor < gap) all.push_back({kFloor, Vec3::UnitZ(), above_floor});
  return all;
}

std::optional<BodyId> PhysicsWorld::overlap(const Collider& collider, const Pose& pose, std::span<const BodyId> ignore,
                                            double depth) const {
  const Bounds bounds = collider.bounds(pose);
  std::vector<Convex> placed;
  for (const BodyId other : impl_->near(bounds, 0)) {
    if (std::find(ignore.begin(), ignore.end(), other) != ignore.end()) continue;
    if (placed.empty()) placed = collider.placed(pose);
    if (any_touch(placed, impl_->at(other), depth)) return other;
  }
  if (bounds.low.z() < -depth) return kFloor;
  return std::nullopt;
}

std::optional<BodyId> PhysicsWorld::overlap(const Shape& shape, const Pose& pose, double opening,
                                            std::span<const BodyId> ignore, double depth) const {
  return overlap(Collider(shape, opening), pose, ignore, depth);
}

std::optional<RayHit> PhysicsWorld::ray(const Vec3& from, const Vec3& to, std::span<const BodyId> ignore) const {
  const Vec3 way = to - from;
  std::optional<RayHit> nearest;
  double best = 1;
  impl_->ask().along(from, way, [&](const std::vector<std::uint32_t>& here, double entered) {
    if (entered > best) return false;
    for (const std::uint32_t number : here) {
      const auto id = BodyId::from_number(number);
      const Body& body = impl_->at(id);
      if (!meets(body.bounds, from, way, best)) continue;
      if (std::find(ignore.begin(), ignore.end(), id) != ignore.end()) continue;
      for (const Convex& part : body.parts()) {
        if (!meets(part.bounds, from, way, best)) continue;
        const auto share = entry(part, from, way);
        const bool first = share && (!nearest || *share < best || (*share == best && id < nearest->body));
        if (!first) continue;
        best = *share;
        nearest = RayHit{id, best};
      }
    }
    return true;
  });
  return nearest;
}

std::vector<BodyId> PhysicsWorld::near(const Bounds& bounds, double gap) const { return impl_->near(bounds, gap); }

Settled PhysicsWorld::settle(std::span<const BodyId> loose, const SettleOptions& options) const {
  if (loose.empty()) return {{}, true, 0};
  Bounds region = impl_->at(loose.front()).bounds;
  for (const BodyId id : loose) region = merged(region, impl_->at(id).bounds);
  region.low.z() = -1;  // include everything below

  std::string key;
  const std::array numbers{static_cast<double>(loose.size()),
                           options.step_s,
                           static_cast<double>(options.max_steps),
                           static_cast<double>(options.calm_steps),
                           static_cast<double>(options.edge_calm_steps),
                           options.calm_m_s,
                           options.calm_rad_s,
                           options.surroundings_m,
                           static_cast<double>(options.most_work)};
  append(key, numbers.data(), sizeof numbers);
  std::vector<SettlingBody> fixed, moving;
  const auto add = [&](const Body& body, std::vector<SettlingBody>& to) {
    to.push_back({body.collider.get(), body.pose, body.mass});
    append(key, body);
  };
  for (const BodyId id : loose) add(impl_->at(id), moving);
  for (const BodyId id : impl_->near(region, options.surroundings_m)) {
    if (std::find(loose.begin(), loose.end(), id) == loose.end()) add(impl_->at(id), fixed);
  }

  constexpr std::size_t kMostRemembered = 1024;
  if (impl_->settled.size() >= kMostRemembered) impl_->settled.clear();
  const auto [known, fresh] = impl_->settled.try_emplace(std::move(key));
  if (fresh) known->second = come_to_rest(fixed, moving, region, options);
  Settled settled{{}, known->second.calm, known->second.work};
  for (std::size_t i = 0; i < loose.size(); ++i) settled.bodies.push_back({loose[i], known->second.poses[i]});
  return settled;
}

}  // namespace unietp
