#include "grounding/place_object.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "simulation/relations.h"
#include "simulation/shape.h"

namespace unietp {
namespace {

constexpr double kDropHeight_m = 0.002;       // over the surface, more than FCL's gap
constexpr double kGapBelowPlaced_m = 0.0002;  // left under what is not let down
constexpr double kHeadroom_m = 0.005;
constexpr double kMostSlide_m = 0.01;  // what moves farther while it settles did not rest where it was put
constexpr double kMostTilt_rad = 0.05;
constexpr double kGapToLike_m = 0.006;  // between things of a kind in a row
constexpr double kSameHeight_m = 0.03;  // between what stands on a surface and what would
constexpr double kEdgeMargin_m = 0.01;  // between a footprint and the surface's edge, where there is room

struct Footprint {
  Vec2 half;
  double yaw;
};

/// Half extents of the upright box turned by `yaw` relative to the surface's axes.
Vec2 turned(const Vec3& size, double yaw) {
  const double c = std::abs(std::cos(yaw)), s = std::abs(std::sin(yaw));
  return {(c * size.x() + s * size.y()) / 2, (s * size.x() + c * size.y()) / 2};
}

/// A yaw at which the box fits on the surface, nullopt when none does: free where there is room, else along an axis;
/// `straight`: along an axis, as people put things on shelves and into drawers.
std::optional<Footprint> draw_footprint(const Vec3& size, const Vec2& room, bool straight, Rng& rng) {
  const double free = rng.uniform(-std::numbers::pi, std::numbers::pi);
  const double right_angle = std::numbers::pi / 2;
  const double first = rng.chance(0.5) ? 0.0 : right_angle;
  for (const double yaw : {straight ? first : free, first, right_angle - first}) {
    const Vec2 half = turned(size, yaw);
    if (half.x() <= room.x() && half.y() <= room.y()) return Footprint{half, yaw};
  }
  return std::nullopt;
}

/// Where the thing would stand in a row with one of its category on the surface, in the surface's frame in W: at its
/// longer sides, turned as it is. Of two of them; as people put like things together.
std::vector<Pose> places_in_a_row(const Workspace& workspace, const Node& node, std::size_t index, const Pose& frame,
                                  const Surface& surface) {
  constexpr std::size_t kMost = 4;
  std::vector<Pose> places;
  const Quat to_surface = frame.rotation.conjugate();
  for (const std::size_t like : workspace.places().of(node.category)) {
    if (like == index || places.size() == kMost) continue;
    const Node& other = workspace.scene().nodes[like];
    const Vec3 at = to_surface * (other.pose.position - frame.position) - surface.center;
    const Quat turn = to_surface * other.pose.rotation;
    const Vec3 up = turn * Vec3::UnitZ();
    const bool stands = std::abs(at.z() - other.size.z() / 2) < kSameHeight_m && up.z() > std::cos(kMostTilt_rad);
    if (!stands || std::abs(at.x()) > surface.half.x() || std::abs(at.y()) > surface.half.y()) continue;
    const bool along_x = other.size.x() <= other.size.y();
    const Vec3 side = turn * (along_x ? Vec3::UnitX() : Vec3::UnitY());
    const double yaw = std::atan2(turn.toRotationMatrix()(1, 0), turn.toRotationMatrix()(0, 0));
    const Vec2 room = surface.half - turned(node.size, yaw);
    const double apart =
        ((along_x ? other.size.x() + node.size.x() : other.size.y() + node.size.y())) / 2 + kGapToLike_m;
    for (const double way : {1.0, -1.0}) {
      const Vec2 there = (at + way * apart * side).head<2>();
      if (std::abs(there.x()) > room.x() || std::abs(there.y()) > room.y()) continue;
      const Vec3 on_surface = surface.center + Vec3(there.x(), there.y(), node.size.z() / 2 + kDropHeight_m);
      places.push_back(frame * upright(on_surface, yaw));
    }
  }
  return places;
}

double tilt_between(const Pose& a, const Pose& b) {
  const double c = (a.rotation * Vec3::UnitZ()).dot(b.rotation * Vec3::UnitZ());
  return std::acos(std::clamp(c, -1.0, 1.0));
}

/// What rests on or in what.
struct Rest {
  Edge edge;
  std::size_t thing = 0, host = 0;
};

/// What physics reads of the body and of the movable things that may rest on or in it, sorted by edge.
std::vector<Rest> rests_around(const Workspace& workspace, std::size_t node) {
  const Scene& scene = workspace.scene();
  std::vector<std::size_t> around{node};
  const auto body = BodyId::node(node);
  for (const BodyId near : workspace.physics().near(workspace.physics().bounds(body), 0.02)) {
    if (near != body && near.is_node() && scene.nodes[near.index()].movable) around.push_back(near.index());
  }
  std::vector<Rest> rests;
  for (const std::size_t thing : around) {
    for (const Link& link : links_of(scene, workspace.physics(), thing)) {
      if (carries(link) && (thing == node || link.to == node))
        rests.push_back({edge_of(scene, thing, link), thing, link.to});
    }
  }
  std::sort(rests.begin(), rests.end(), [](const Rest& a, const Rest& b) { return a.edge < b.edge; });
  return rests;
}

/// The one thing wrong with where the node came to rest, or "".
std::string misplaced(const Workspace& workspace, std::size_t node, std::optional<Predicate> wanted,
                      std::optional<std::size_t> receptacle) {
  const auto& nodes = workspace.scene().nodes;
  bool found = !wanted;
  for (const auto& [edge, thing, host] : rests_around(workspace, node)) {
    if (thing == node && wanted == edge.relation && host == receptacle) {
      found = true;
      continue;  // it was asked for
    }
    if (!allowed(workspace.knowledge(), nodes[thing], edge.relation, nodes[host])) {
      return edge.from + " would be " + std::string(info(edge.relation).name) + " " + edge.to;
    }
  }
  return found ? "" : "does not come to rest in the relation asked";
}

bool blocks_a_door(const Workspace& workspace, const Bounds& bounds, std::size_t except) {
  constexpr double kSlack_m = 1e-6;
  const auto& sweeps = workspace.sweeps();
  const auto near = workspace.physics().near(bounds, workspace.farthest_sweep() + kSlack_m);
  return std::any_of(near.begin(), near.end(), [&](BodyId i) {
    if (!i.is_node() || i.index() == except || i.index() >= sweeps.size()) return false;
    const auto& sweep = sweeps[i.index()];
    return sweep && overlap(*sweep, bounds);
  });
}

/// Whether a thing that stands with its whole footprint on a surface is in equilibrium there: flat below, its weight
/// over its base, on the floor or on something level that never moves. Letting it down in physics would show nothing.
bool stands_firmly(const Workspace& workspace, const TrialNode& trial, std::optional<std::size_t> receptacle) {
  const auto& nodes = workspace.scene().nodes;
  const Node& node = nodes[trial.body().index()];
  const auto& parts = trial.shape().parts;
  if (node.opening > 0 || !node.boards.empty()) return false;
  if (std::any_of(parts.begin(), parts.end(), [](const Part& part) { return part.kind == Part::Kind::Sphere; }))
    return false;
  if (!receptacle) return true;
  const Node& host = nodes[*receptacle];
  return !host.movable && host.opening == 0 && (host.pose.rotation * Vec3::UnitZ()).z() > 1 - 1e-9;
}

/// Where the thing of the trial comes to rest when it is let go at a pose; nullopt when that is elsewhere.
std::optional<Pose> let_go(const Workspace& workspace, const TrialNode& trial, const Pose& pose) {
  const std::array<BodyId, 1> self{trial.body()};
  const Settled settled = workspace.physics().settle(self);
  const Pose rest = settled.bodies.front().pose;
  const bool stays =
      settled.calm && (rest.position - pose.position).norm() < kMostSlide_m && tilt_between(rest, pose) < kMostTilt_rad;
  return stays ? std::optional(rest) : std::nullopt;
}

/// Tests one candidate pose; the pose at rest, or nullopt with the obstacle named.
std::optional<Pose> try_pose(Workspace& workspace, double opening, TrialNode& trial, const Pose& pose,
                             std::optional<Predicate> wanted, std::optional<std::size_t> receptacle,
                             const PlacementOptions& options, std::string& obstacle) {
  const std::array<BodyId, 1> self{trial.body()};
  if (const auto hit = workspace.checker().hit(trial.shape(), pose, opening, PlacementChecker::kGap_m, self)) {
    obstacle = "hits " + workspace.name_of(*hit);
    return std::nullopt;
  }
  const Bounds bounds = bounds_of(trial.shape(), pose, opening);
  if (options.within && !overlap(*options.within, bounds)) {
    obstacle = "lies outside of where it is wanted";
    return std::nullopt;
  }
  const std::size_t host = receptacle.value_or(workspace.scene().nodes.size() + 1);
  if (options.keep_sweeps_clear && blocks_a_door(workspace, bounds, host)) {
    obstacle = "stands in the way of a door";
    return std::nullopt;
  }
  // From a hair's breadth: what falls two millimeters takes a fifth longer to come to rest.
  const Pose let_down{pose.position - Vec3(0, 0, kDropHeight_m - kGapBelowPlaced_m), pose.rotation};
  if (!options.settle) return let_down;
  trial.move(let_down);
  auto rest =
      stands_firmly(workspace, trial, receptacle) ? std::optional(let_down) : let_go(workspace, trial, let_down);
  if (!rest) {
    obstacle = "does not stay where it is put";
    return std::nullopt;
  }
  trial.move(*rest);
  obstacle = misplaced(workspace, trial.body().index(), wanted, receptacle);
  if (!obstacle.empty()) return std::nullopt;
  return rest;
}

}  // namespace

FoundPlace find_place(Workspace& workspace, const Node& node, std::size_t index, Predicate relation,
                      std::size_t receptacle, const PlacementOptions& options, Rng rng) {
  const Node host = workspace.scene().nodes[receptacle];
  const Shape host_shape = shape_of(host);
  std::vector<Surface> surfaces;
  std::vector<double> areas;
  for (const Surface& surface : host_shape.surfaces) {
    if ((surface.cavity >= 0) != (relation == Predicate::Inside)) continue;
    const bool open_above =
        surface.cavity >= 0 && host_shape.cavities[static_cast<std::size_t>(surface.cavity)].open_above;
    if (!open_above && node.size.z() + kDropHeight_m + kHeadroom_m > surface.clearance) continue;
    surfaces.push_back(surface);
    areas.push_back(surface.half.prod());
  }
  FoundPlace found;
  found.obstacle = "is too high for every surface of " + host.id;
  if (surfaces.empty()) return found;

  TrialNode trial(workspace, node, index);
  for (int draw = 0; draw < options.draws; ++draw) {
    const Surface& surface = surfaces[rng.weighted(areas)];
    const Pose frame = host.pose * joint_motion(host_shape, surface.joint, host.opening);
    if (draw == 0 && !options.aligned) {
      for (const Pose& pose : places_in_a_row(workspace, node, index, frame, surface)) {
        found.pose = try_pose(workspace, node.opening, trial, pose, relation, receptacle, options, found.obstacle);
        if (found.pose) return found;
      }
    }
    auto footprint = draw_footprint(node.size, surface.half, surface.cavity >= 0, rng);
    if (options.aligned) {
      const Vec2 straight = turned(node.size, 0);
      footprint = (surface.half - straight).minCoeff() < 0 ? std::nullopt : std::optional(Footprint{straight, 0});
    }
    if (!footprint) {
      found.obstacle = "is too wide for a surface of " + host.id;
      continue;
    }
    const Vec2 slack = surface.half - footprint->half;
    const Vec2 room = (slack - Vec2::Constant(kEdgeMargin_m)).cwiseMax(slack / 2);
    const Vec3 on_surface = surface.center + Vec3(rng.uniform(-1, 1) * room.x(), rng.uniform(-1, 1) * room.y(),
                                                  node.size.z() / 2 + kDropHeight_m);
    const Pose pose = frame * upright(on_surface, footprint->yaw);
    found.pose = try_pose(workspace, node.opening, trial, pose, relation, receptacle, options, found.obstacle);
    if (found.pose) return found;
  }
  return found;
}

FoundPlace find_place_on_floor(Workspace& workspace, const Node& node, std::size_t index, const Bounds& area,
                               const PlacementOptions& options, Rng rng) {
  FoundPlace found;
  found.obstacle = "does not fit on the floor there";
  const Vec2 center = (area.low + area.high).head<2>() / 2, half = (area.high - area.low).head<2>() / 2;
  TrialNode trial(workspace, node, index);
  for (int draw = 0; draw < options.draws; ++draw) {
    const auto footprint = draw_footprint(node.size, half, false, rng);
    if (!footprint) continue;
    const Vec2 slack = half - footprint->half;
    const Vec2 at = center + Vec2(rng.uniform(-1, 1) * slack.x(), rng.uniform(-1, 1) * slack.y());
    const Pose pose = upright({at.x(), at.y(), node.size.z() / 2 + kDropHeight_m}, footprint->yaw);
    found.pose = try_pose(workspace, node.opening, trial, pose, std::nullopt, std::nullopt, options, found.obstacle);
    if (found.pose) return found;
  }
  return found;
}

}  // namespace unietp
