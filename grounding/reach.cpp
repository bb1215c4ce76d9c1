#include "grounding/reach.h"

#include <algorithm>
#include <array>

#include "simulation/navigation.h"
#include "simulation/spots.h"
#include "simulation/swing.h"

namespace unietp {
namespace {

void place(Scene& scene, PhysicsWorld& world, std::size_t index, const Pose& pose) {
  scene.nodes[index].pose = pose;
  world.move(static_cast<BodyId>(index), pose);
}

/// Bodies near some bounds that can be carried away, but for one.
std::vector<BodyId> loose_near(const Scene& scene, const PhysicsWorld& world, const Bounds& bounds, double gap,
                               std::size_t except) {
  std::vector<BodyId> loose;
  for (const BodyId id : world.near(bounds, gap)) {
    if (id < scene.nodes.size() && id != except && scene.nodes[id].movable) loose.push_back(id);
  }
  return loose;
}

/// Places to stand for work at a target, found as they are asked for.
class Footholds {
 public:
  Footholds(const Scene& scene, const PhysicsWorld& world, const Walk& walk, const Profile& profile, std::size_t target,
            std::size_t held)
      : scene_(scene), world_(world), profile_(profile), target_(target), held_{static_cast<BodyId>(held)} {
    const Node& node = scene.nodes[target];
    const double span = node.size.norm() / 2 + profile.reach_m;
    const Vec2 middle = node.pose.position.head<2>();
    const NavigationGrid& grid = walk.grid;
    const auto from = grid.cell_at(middle - Vec2::Constant(span)), to = grid.cell_at(middle + Vec2::Constant(span));
    for (int y = from.y; y <= to.y; ++y) {
      for (int x = from.x; x <= to.x; ++x) {
        if (!grid.free({x, y}) || walk.steps[grid.index({x, y})] < 0) continue;
        const Vec2 at = grid.centre({x, y});
        if (reach_distance(node, at, profile) <= profile.reach_m) places_.push_back({at, std::nullopt});
      }
    }
  }
  /// The arm gets to the spot from one of them from which the target is in sight.
  bool reach(const Vec3& spot) {
    return std::any_of(places_.begin(), places_.end(), [&](Place& place) {
      if (arm_length(spot, place.at, profile_) > profile_.reach_m) return false;
      if (!place.sees) place.sees = sees(scene_, world_, profile_, place.at, target_, held_);
      return *place.sees;
    });
  }

 private:
  struct Place {
    Vec2 at;
    std::optional<bool> sees;
  };
  const Scene& scene_;
  const PhysicsWorld& world_;
  const Profile& profile_;
  std::size_t target_;
  std::array<BodyId, 1> held_;
  std::vector<Place> places_;
};

bool spot_in(const Scene& scene, const PhysicsWorld& world, const Walk& walk, const Profile& profile, std::size_t thing,
             std::size_t target, bool inside) {
  const Node& node = scene.nodes[thing];
  const Node& receptacle = scene.nodes[target];
  const auto& collider = world.collider(static_cast<BodyId>(thing));
  const auto& shape = world.collider(static_cast<BodyId>(target)).shape;
  if (receptacle.movable)
    return for_each_spot(receptacle, shape, node.size, inside, true, [](const Pose&) { return false; }).any_fit;
  const auto loose =
      loose_near(scene, world, world.bounds(static_cast<BodyId>(target)), node.size.norm(), scene.nodes.size());
  Footholds footholds(scene, world, walk, profile, target, thing);
  bool found = false;
  for_each_spot(receptacle, shape, node.size, inside, true, [&](const Pose& pose) {
    found = !world.overlap(collider, pose, loose) && footholds.reach(pose.position);
    return !found;
  });
  return found;
}

}  // namespace

Reach::Reach(const Home& home, const Scene& scene, const PhysicsWorld& world, const Profile& profile)
    : home_(home), scene_(scene), world_(world), profile_(profile), walk_(walk_of(home, scene)) {}

bool Reach::room(const Room& room) const {
  const NavigationGrid& grid = walk_->grid;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      if (walk_->steps[grid.index({x, y})] >= 0 && contains(room.polygon, grid.centre({x, y}))) return true;
    }
  }
  return false;
}

bool Reach::object(std::size_t index) {
  const std::vector<std::size_t> doors = shut_around(index);
  if (doors.empty()) return standing_place(scene_, world_, walk_->grid, walk_->steps, profile_, index).has_value();
  // Each door must be reachable shut, and the thing with all of them open.
  if (!std::all_of(doors.begin(), doors.end(), [&](std::size_t door) { return object(door); })) return false;
  Opened& opened = with_open(doors);
  const Pose before = opened.scene.nodes[index].pose;
  slide_along(opened, doors, index);
  const bool reached =
      standing_place(opened.scene, opened.world, opened.walk->grid, opened.walk->steps, profile_, index).has_value();
  place(opened.scene, opened.world, index, before);
  return reached;
}

bool Reach::spot_for(std::size_t thing, std::size_t target, bool inside) {
  std::vector<std::size_t> doors = shut_around(target);
  const Node& receptacle = scene_.nodes[target];
  if (inside && receptacle.openable && receptacle.opening < 0.5) doors.push_back(target);
  if (doors.empty()) return spot_in(scene_, world_, *walk_, profile_, thing, target, inside);
  if (!std::all_of(doors.begin(), doors.end(), [this](std::size_t door) { return swings(door); })) return false;
  const Opened& opened = with_open(doors);
  return spot_in(opened.scene, opened.world, *opened.walk, profile_, thing, target, inside);
}

bool Reach::swings(std::size_t index) const {
  const Node& node = scene_.nodes[index];
  const auto body = static_cast<BodyId>(index);
  const Shape& shape = world_.collider(body).shape;
  if (node.movable || !node.openable || shape.joints.empty()) return true;
  const auto swept = sweep_of(node);
  auto ignore = loose_near(scene_, world_, swept.value_or(world_.bounds(body)), 0, index);
  ignore.push_back(body);
  return !in_the_way(world_, node, shape, node.opening < 0.5 ? 1 : 0, ignore);
}

std::vector<std::size_t> Reach::shut_around(std::size_t index) const {
  std::vector<std::size_t> doors;
  for (const Edge& edge : scene_.edges) {
    if (edge.relation != Predicate::Inside || edge.from != scene_.nodes[index].id) continue;
    const Node* container = find_node(scene_, edge.to);
    if (container != nullptr && container->openable && container->opening < 0.5)
      doors.push_back(static_cast<std::size_t>(container - scene_.nodes.data()));
  }
  return doors;
}

Reach::Opened& Reach::with_open(const std::vector<std::size_t>& doors) {
  if (opened_ && opened_->doors == doors) return *opened_;
  opened_ = Opened{doors, scene_, world_, nullptr};
  for (const std::size_t door : doors) {
    const Node& container = scene_.nodes[door];
    opened_->scene.nodes[door].opening = 1;
    opened_->world.set(static_cast<BodyId>(door), shape_of(container), container.pose, 1, container.mass);
  }
  opened_->walk = walk_of(home_, opened_->scene);
  return *opened_;
}

/// Moves a thing with the drawer that it lies in.
void Reach::slide_along(Opened& opened, const std::vector<std::size_t>& doors, std::size_t index) const {
  for (const std::size_t door : doors) {
    const Node& container = scene_.nodes[door];
    const Shape shape = shape_of(container);
    for (const Cavity& cavity : shape.cavities) {
      if (cavity.joint < 0) continue;
      const Pose motion = joint_motion(shape, cavity.joint, 1);
      const Pose& pose = opened.scene.nodes[index].pose;
      place(opened.scene, opened.world, index, container.pose * (motion * (inverse(container.pose) * pose)));
    }
  }
}

}  // namespace unietp
