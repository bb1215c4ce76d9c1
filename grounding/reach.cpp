#include "grounding/reach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "grounding/packing.h"
#include "scene/edge_change.h"
#include "simulation/agent_moves.h"
#include "simulation/spots.h"
#include "simulation/standing.h"
#include "simulation/swing.h"

namespace unietp {
namespace {

void place(Scene& scene, PhysicsWorld& world, std::size_t index, const Pose& pose) {
  scene.nodes.edit(index).pose = pose;
  world.move(BodyId::node(index), pose);
}

/// Bodies near some bounds that can be carried away, but for one.
std::vector<BodyId> loose_near(const Scene& scene, const PhysicsWorld& world, const Bounds& bounds, double gap,
                               std::size_t except) {
  std::vector<BodyId> loose;
  for (const BodyId id : world.near(bounds, gap)) {
    if (id.is_node() && id.index() != except && scene.nodes[id.index()].movable) loose.push_back(id);
  }
  return loose;
}

/// Where the body can walk to and has the node within its arm's reach.
std::vector<Vec2> places_by(const Node& node, const Walk& walk, const Profile& profile) {
  std::vector<Vec2> places;
  const double span = node.size.norm() / 2 + profile.reach_m;
  const Vec2 middle = node.pose.position.head<2>();
  const NavigationGrid& grid = walk.grid;
  const auto from = grid.cell_at(middle - Vec2::Constant(span)), to = grid.cell_at(middle + Vec2::Constant(span));
  for (int y = from.y; y <= to.y; ++y) {
    for (int x = from.x; x <= to.x; ++x) {
      if (!walk.reached.has(x, y)) continue;
      const Vec2 at = grid.center({x, y});
      if (reach_distance(node, at, profile) <= profile.reach_m) places.push_back(at);
    }
  }
  return places;
}

/// Where the body stands by a target; mostly it is the spot on it that is wanting, and this is not asked.
using Standing = std::function<const std::vector<Vec2>&()>;

/// Places to stand for work at a target, found as they are asked for.
class StandingPlaces {
 public:
  StandingPlaces(const Scene& scene, const PhysicsWorld& world, const Standing& standing, const Profile& profile,
                 std::size_t target, std::size_t held)
      : scene_(scene),
        world_(world),
        standing_(standing),
        profile_(profile),
        target_(target),
        held_{BodyId::node(held)} {}
  /// The arm gets to the spot from one of them from which the target is in sight.
  bool reach(const Vec3& spot) {
    if (!places_) {
      places_.emplace();
      for (const Vec2& at : standing_()) places_->push_back({at, std::nullopt});
    }
    return std::any_of(places_->begin(), places_->end(), [&](Place& place) {
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
  const Standing& standing_;
  const Profile& profile_;
  std::size_t target_;
  std::array<BodyId, 1> held_;
  std::optional<std::vector<Place>> places_;  // when first asked for
};

/// What is asked about a thing and where it is to go.
struct PlacementQuestion {
  std::size_t thing = 0, target = 0;
  bool inside = false;
};

/// What was found of spots for a thing.
struct Spots {
  std::vector<Pose> within_reach;
  bool any_free = false;  // of what is fixed
};

/// The spots, at most so many, that are free of what is fixed and within the arm's reach. On what can be carried itself
/// only the size is asked for.
Spots spots_for(const Scene& scene, const PhysicsWorld& world, const Standing& standing, const Profile& profile,
                const PlacementQuestion& question, std::size_t most) {
  const auto& [thing, target, inside] = question;
  const Node& node = scene.nodes[thing];
  const Node& receptacle = scene.nodes[target];
  const auto& collider = world.collider(BodyId::node(thing));
  const auto& shape = world.collider(BodyId::node(target)).shape;
  const auto loose = loose_near(scene, world, world.bounds(BodyId::node(target)), node.size.norm(), scene.nodes.size());
  std::optional<StandingPlaces> standing_places;
  if (!receptacle.movable) standing_places.emplace(scene, world, standing, profile, target, thing);
  Spots spots;
  for_each_spot(receptacle, shape, node.size, inside, true, [&](const Pose& pose) {
    if (standing_places && world.overlap(collider, pose, loose)) return true;
    spots.any_free = true;
    if (!standing_places || standing_places->reach(pose.position)) spots.within_reach.push_back(pose);
    return spots.within_reach.size() < most;
  });
  return spots;
}

constexpr std::size_t kMostSpots = 4000;  // looked at for one thing

/// Things that take up less of the largest surface than this, together, are taken to find room.
constexpr double kAmple = 0.25;

bool is_ample(const Scene& scene, const Shape& shape, const std::vector<std::size_t>& things, bool inside) {
  double largest = 0, taken = 0;
  for (const Surface& surface : shape.surfaces) {
    if ((surface.cavity >= 0) == inside) largest = std::max(largest, 4 * surface.half.x() * surface.half.y());
  }
  for (const std::size_t thing : things) taken += scene.nodes[thing].size.x() * scene.nodes[thing].size.y();
  return taken <= kAmple * largest;
}

/// More clearly than it must (shows_clearly): the agent stands and turns in steps, and seldom just so.
bool shows_well(const PixelBox& box) {
  constexpr int kLeastSide_px = 6;
  return shows_clearly(box) && std::min(box[2] - box[0], box[3] - box[1]) + 1 >= kLeastSide_px;
}

/// Straight at it, or with it near an edge or a corner of the picture, where a wide lens draws it larger.
bool shows_in(const Scene& scene, const std::vector<Vec2>& places, const Profile& profile, std::size_t thing,
              Viewer& viewer) {
  constexpr double kToTheEdge = 0.8;
  const Node& node = scene.nodes[thing];
  const double down = kToTheEdge * profile.vertical_fov_deg * std::numbers::pi / 360;
  const double aside = std::atan(std::tan(down) * profile.image_width / profile.image_height);
  constexpr std::array<std::array<int, 2>, 6> kTurnAndTilt{{{0, 0}, {0, -1}, {1, 0}, {-1, 0}, {1, -1}, {-1, -1}}};
  for (const auto& [turn, tilt] : kTurnAndTilt) {
    const bool shown = std::any_of(places.begin(), places.end(), [&, turn = turn, tilt = tilt](const Vec2& at) {
      Agent eye;
      eye.position = at;
      eye = facing(eye, node.pose.position, profile);
      eye.yaw += turn * aside;
      eye.pitch += tilt * down;
      const auto whole = viewer.unhidden_box_of(scene, thing, eye, profile);
      if (!whole || !shows_well(*whole)) return false;
      const auto box = viewer.box_of({scene}, thing, eye, profile);
      return box && shows_well(*box);
    });
    if (shown) return true;
  }
  return false;
}

}  // namespace

Reach::Reach(const Home& home, const Scene& scene, const GrownScene& grown, const Profile& profile)
    : home_(&home),
      scene_(scene),
      places_(grown.places),
      world_(grown.physics),
      profile_(profile),
      walk_(grown.walk),
      viewer_(*home.viewer) {}

Reach::Reach(const Scene& scene, const NodeIndex& places, const PhysicsWorld& world, std::shared_ptr<const Walk> walk,
             const Profile& profile)
    : home_(nullptr), scene_(scene), places_(places), world_(world), profile_(profile), walk_(std::move(walk)) {}

std::optional<std::string> Reach::unreached() const { return newly_unreached(*home_, scene_, walk_); }

bool Reach::room(const Room& room) const {
  const NavigationGrid& grid = walk_->grid;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      if (walk_->reached.has(x, y) && contains(room.polygon, grid.center({x, y}))) return true;
    }
  }
  return false;
}

bool Reach::object(std::size_t index) {
  const auto known = reached_.find(index);
  if (known != reached_.end()) return known->second;
  const bool reached = stands_by(index);
  return reached_.emplace(index, reached).first->second;
}

bool Reach::shows(std::size_t index) {
  constexpr int kSurely_px = 12;  // each way, as far as the arm reaches
  const Node& node = scene_.nodes[index];
  Vec3 sizes = node.size;
  std::sort(sizes.data(), sizes.data() + 3);
  const double pixels_at_1m =
      profile_.image_height / 2.0 / std::tan(profile_.vertical_fov_deg * std::numbers::pi / 360);
  if (sizes[1] * pixels_at_1m / profile_.reach_m >= kSurely_px) return true;
  const auto known = shown_.find(index);
  if (known != shown_.end()) return known->second;
  const auto doors = shut_around(index);
  bool shown = false;
  if (doors.empty()) {
    shown = shows_in(scene_, standing_by(index), profile_, index, *viewer_);
  } else {
    Opened& opened = with_open(doors);
    const Walk& around = walk(opened);
    const Pose before = opened.scene.nodes[index].pose;
    slide_along(opened, doors, index);
    const auto places = places_by(opened.scene.nodes[index], around, profile_);  // where it slid to
    shown = shows_in(opened.scene, places, profile_, index, *viewer_);
    place(opened.scene, opened.world, index, before);
  }
  return shown_.emplace(index, shown).first->second;
}

bool Reach::stands_by(std::size_t index) {
  const std::vector<std::size_t> doors = shut_around(index);
  if (doors.empty()) return standing_place(scene_, world_, walk_->grid, walk_->reached, profile_, index).has_value();
  // Each door must be reachable shut, and the thing with all of them open.
  if (!std::all_of(doors.begin(), doors.end(), [&](std::size_t door) { return object(door); })) return false;
  Opened& opened = with_open(doors);
  const Walk& around = walk(opened);
  const Pose before = opened.scene.nodes[index].pose;
  slide_along(opened, doors, index);
  const bool reached =
      standing_place(opened.scene, opened.world, around.grid, around.reached, profile_, index).has_value();
  place(opened.scene, opened.world, index, before);
  return reached;
}

std::vector<std::size_t> Reach::doors_before(std::size_t target, bool inside) const {
  std::vector<std::size_t> doors = shut_around(target);
  const Node& receptacle = scene_.nodes[target];
  if (inside && receptacle.openable && receptacle.opening < 0.5) doors.push_back(target);
  return doors;
}

bool Reach::spot_for(std::size_t thing, std::size_t target, bool inside) {
  const PlacementQuestion question{thing, target, inside};
  const Vec3& size = scene_.nodes[thing].size;
  const Digest& form = world_.collider(BodyId::node(thing)).digest;
  const Full asked{target, inside, form.a, form.b, size.x(), size.y(), size.z()};
  if (full_.contains(asked)) return false;
  const auto found = [&](const Spots& spots) {
    if (!spots.any_free) full_.insert(asked);
    return !spots.within_reach.empty();
  };
  const std::vector<std::size_t> doors = doors_before(target, inside);
  const auto here = [&]() -> const std::vector<Vec2>& { return standing_by(target); };
  if (doors.empty()) return found(spots_for(scene_, world_, here, profile_, question, 1));
  if (!std::all_of(doors.begin(), doors.end(), [this](std::size_t door) { return swings(door); })) return false;
  Opened& opened = with_open(doors);
  const auto there = [&]() -> const std::vector<Vec2>& { return standing_by(opened, target); };
  return found(spots_for(opened.scene, opened.world, there, profile_, question, 1));
}

bool Reach::room_for_all(const std::vector<std::size_t>& things, std::size_t target, bool inside) {
  const auto collider = [this](std::size_t node) -> const Collider& { return world_.collider(BodyId::node(node)); };
  if (is_ample(scene_, collider(target).shape, things, inside)) return true;
  const auto holds_others = [&](std::size_t thing) { return !collider(thing).shape.surfaces.empty(); };
  if (inside && std::any_of(things.begin(), things.end(), holds_others)) return true;
  const std::vector<std::size_t> doors = doors_before(target, inside);
  Opened* opened = doors.empty() ? nullptr : &with_open(doors);
  const Scene& scene = opened != nullptr ? opened->scene : scene_;
  const PhysicsWorld& world = opened != nullptr ? opened->world : world_;
  const auto standing = [&]() -> const std::vector<Vec2>& {
    return opened != nullptr ? standing_by(*opened, target) : standing_by(target);
  };
  std::vector<ObjectWithPoses> fitting;
  for (const std::size_t thing : things) {
    ObjectWithPoses one{&collider(thing),
                        spots_for(scene, world, standing, profile_, {thing, target, inside}, kMostSpots).within_reach};
    if (one.spots.size() == kMostSpots) return true;
    const Predicate relation = inside ? Predicate::Inside : Predicate::On;
    if (has_edge(scene_, relation, scene_.nodes[thing].id, scene_.nodes[target].id)) {
      if (opened != nullptr) return true;  // it may lie in a drawer, which took it along
      one.spots.push_back(scene_.nodes[thing].pose);
    }
    fitting.push_back(std::move(one));
  }
  return fit_together(fitting);
}

bool Reach::swings(std::size_t node) const { return !what_blocks(scene_, world_, node); }

std::optional<BodyId> what_blocks(const Scene& scene, const PhysicsWorld& world, std::size_t index) {
  const Node& node = scene.nodes[index];
  const auto body = BodyId::node(index);
  const Shape& shape = world.collider(body).shape;
  if (node.movable || !node.openable || shape.joints.empty()) return std::nullopt;
  const auto swept = sweep_of(node);
  auto ignore = loose_near(scene, world, swept.value_or(world.bounds(body)), 0, index);
  ignore.push_back(body);
  return joint_obstacle(world, node, shape, node.opening < 0.5 ? 1 : 0, ignore);
}

std::vector<std::size_t> Reach::shut_around(std::size_t index) const {
  std::vector<std::size_t> doors;
  for (const Edge& edge : edges_from(scene_.edges, Predicate::Inside, scene_.nodes[index].id)) {
    const auto container = places_.find(edge.to);
    if (container && scene_.nodes[*container].openable && scene_.nodes[*container].opening < 0.5)
      doors.push_back(*container);
  }
  return doors;
}

Reach::Opened& Reach::with_open(const std::vector<std::size_t>& doors) {
  if (opened_ && opened_->doors == doors) return *opened_;
  if (!opened_) opened_ = Opened{{}, without_edges(scene_), world_, nullptr, {}};
  for (const std::size_t door : opened_->doors) {  // shut again
    const Node& container = scene_.nodes[door];
    const auto body = BodyId::node(door);
    opened_->scene.nodes.edit(door).opening = container.opening;
    opened_->world.set(body, world_.share(body), container.pose, container.mass);
  }
  for (const std::size_t door : doors) {
    const Node& container = scene_.nodes[door];
    opened_->scene.nodes.edit(door).opening = 1;
    opened_->world.set(BodyId::node(door), shape_of(container), container.pose, 1, container.mass);
  }
  opened_->walk.reset();
  opened_->doors = doors;
  opened_->places_by.clear();
  return *opened_;
}

const std::vector<Vec2>& Reach::standing_by(std::size_t index) {
  const auto [known, fresh] = places_by_.try_emplace(index);
  if (fresh) known->second = places_by(scene_.nodes[index], *walk_, profile_);
  return known->second;
}

const std::vector<Vec2>& Reach::standing_by(Opened& opened, std::size_t index) const {
  const auto [known, fresh] = opened.places_by.try_emplace(index);
  if (fresh) known->second = places_by(opened.scene.nodes[index], walk(opened), profile_);
  return known->second;
}

const Walk& Reach::walk(Opened& opened) const {
  if (opened.walk == nullptr) {
    auto walk = std::make_shared<Walk>(Walk{walk_->grid, {}, {}});
    for (const std::size_t door : opened.doors) {
      const Shape shape = shape_of(opened.scene.nodes[door]);
      walk->grid.update(door, &opened.scene.nodes[door], &shape);
    }
    walk->reached = walk->grid.reached_from(walk->grid.cell_at(scene_.agent.position), walk_->grid, walk_->reached);
    opened.walk = std::move(walk);
  }
  return *opened.walk;
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
