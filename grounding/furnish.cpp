#include "grounding/furnish.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "grounding/floor_plan.h"
#include "simulation/shape.h"
#include "simulation/walls.h"

namespace unietp {
namespace {

const double kFromWall_m = Scene().wall_thickness / 2 + 0.012;  // of a back from the polygon's edge
constexpr double kGap_m = 0.01;                                 // between pieces
constexpr double kPassage_m = 2.0;                              // height that keep-outs reach to
constexpr double kDoorwayDepth_m = 0.8;
constexpr double kFarthestKeepOut_m = 3;  // from a piece's body, more than any front or door has
constexpr double kAisle_m = 0.75;         // around what stands free
constexpr double kRestGap_m = 0.002;
constexpr double kFurnitureMargin_m = 0.02;
constexpr double kUnderCeiling_m = 0.01;
constexpr double kInRow = 0.5;       // how often what stands at a wall is tried next to another piece first
constexpr double kInRun = 0.85;      // how often the next piece of a run is
constexpr double kFreeSide_m = 0.5;  // of what stands free: from each side to the room's edge
constexpr double kBetweenSeats_m = 0.08, kSeat_m = 0.55;  // depth of a chair at a table
constexpr double kDesk_m = 0.8;                           // least width of what one sits at
constexpr double kNeighbor_m = 0.06, kInRun_m = 0.02;     // farthest from the neighbor
constexpr double kAside_m = 0.25;                         // of what faces a piece, from its middle
constexpr double kAbove_m = 0.25;  // of what treats a thing that stands on it: more than a pot's height
constexpr double kThickestRug_m = 0.04;
constexpr double kLidLean = 0.36;  // how far an open lid stands out behind, as a share of its length

struct Candidate {
  Pose pose;
  std::optional<std::size_t> host;  // node that it stands on, at, beside or above
};

/// Yaw that turns the object's front (-y) to the unit vector `front`.
double yaw_facing(const Vec2& front) { return std::atan2(front.x(), -front.y()); }

Vec2 inward_normal(std::uint64_t side) {
  constexpr std::array<std::array<double, 2>, 4> kNormals{{{0, 1}, {-1, 0}, {0, -1}, {1, 0}}};
  return {kNormals[side][0], kNormals[side][1]};
}

double default_height(const Node& node, double wall_height) {
  double bottom = 1.45 - node.size.z() / 2;  // a picture at eye height
  if (node.archetype == Archetype::Cabinet) bottom = 1.45;
  if (node.archetype == Archetype::Shelf) bottom = node.size.z() < 0.15 ? 1.2 : 0.9;
  return std::clamp(bottom, 0.02, std::max(0.02, wall_height - node.size.z() - 0.05));
}

/// The whole wall of a side.
WallStretch whole_wall(const Bounds& room, std::uint64_t side) {
  const int along = side % 2 == 0 ? 0 : 1;
  return {static_cast<int>(side), room.low[along], room.high[along]};
}

/// Back to a wall; along it where `share` in [0, 1] says. nullopt when the stretch is too short.
std::optional<Pose> at_wall(const Bounds& room, const WallStretch& wall, double share, const Node& node,
                            double bottom) {
  const Vec2 normal = inward_normal(static_cast<std::uint64_t>(wall.side));
  const int across = normal.x() != 0 ? 0 : 1, along = 1 - across;
  Vec3 position;
  const bool leans_back =
      node.openable && (node.archetype == Archetype::Lidded || node.archetype == Archetype::Folding);
  const double depth = kFromWall_m + node.size.y() / 2 + (leans_back ? kLidLean * node.size.y() : 0);
  position[across] = normal[across] > 0 ? room.low[across] + depth : room.high[across] - depth;
  const double low = wall.from + kFromWall_m + node.size.x() / 2;
  const double high = wall.to - kFromWall_m - node.size.x() / 2;
  if (low > high) return std::nullopt;
  position[along] = low + share * (high - low);
  position.z() = bottom + node.size.z() / 2;
  return upright(position, yaw_facing(normal));
}

std::vector<std::size_t> hosts_in(const Workspace& workspace, std::size_t room, const std::string& category) {
  std::vector<std::size_t> hosts;
  const Scene& scene = workspace.scene();
  for (const std::size_t i : workspace.places().of(category)) {
    if (contains(scene.rooms[room].polygon, scene.nodes[i].pose.position.head<2>())) hosts.push_back(i);
  }
  return hosts;
}

/// Nodes in a room, in those at most so far from it and in none, ascending.
std::vector<std::size_t> nodes_near(const Workspace& workspace, std::size_t room, double gap) {
  const Scene& scene = workspace.scene();
  const Bounds bounds = room_bounds(scene.rooms[room], scene.wall_height);
  std::vector<bool> rooms;
  for (const Room& other : scene.rooms) rooms.push_back(overlap(room_bounds(other, scene.wall_height), bounds, gap));
  rooms.push_back(true);  // what hangs in a wall
  return workspace.nodes_in(rooms);
}

/// Pose in the host's frame for what stands on it: anywhere along it, its back near the host's back.
std::optional<Vec3> draw_on_top(const Node& host, const Node& node, Rng& rng) {
  std::vector<Surface> tops;
  for (const Surface& surface : shape_of(host).surfaces) {
    if (surface.cavity < 0 && surface.joint < 0 && node.size.z() + 0.02 < surface.clearance) tops.push_back(surface);
  }
  if (tops.empty()) return std::nullopt;
  const Surface& top = rng.pick(tops);
  const Vec2 slack = top.half - node.size.head<2>() / 2;
  if (slack.minCoeff() < 0) return std::nullopt;
  const double back = std::min(slack.y(), rng.uniform(0.0, 0.08));
  return top.center + Vec3(rng.uniform(-1, 1) * slack.x(), slack.y() - back, node.size.z() / 2 + kRestGap_m);
}

/// Pose next to a host, backs in line, `bottom` meters over the floor, at most `gap` away.
Pose beside(const Node& host, const Node& node, double gap, Rng& rng, double bottom = 0) {
  const Vec3 half = host.size / 2, own = node.size / 2;
  const double side = rng.chance(0.5) ? 1 : -1;
  const Vec3 spot(side * (half.x() + own.x() + rng.uniform(0.015, gap)), half.y() - own.y(),
                  bottom + own.z() - host.pose.position.z());
  return host.pose * Pose{spot, Quat::Identity()};
}

/// A rug or carpet: one walks on it, and furniture stands on it.
bool covers_the_floor(const Node& node) {
  return !node.movable && node.archetype == Archetype::Plate && node.size.z() < kThickestRug_m &&
         node.pose.position.z() < kThickestRug_m;
}

/// Lifts what would stand on a rug, with its whole footprint, by the rug's thickness.
Pose on_its_rug(const Workspace& workspace, std::size_t room, const Node& node) {
  const Bounds body = bounds_of(node.pose, node.size);
  if (body.low.z() > kThickestRug_m || covers_the_floor(node)) return node.pose;
  for (const std::size_t i : workspace.nodes_in(room)) {
    const Node& rug = workspace.scene().nodes[i];
    if (!covers_the_floor(rug)) continue;
    const Bounds area = bounds_of(rug.pose, rug.size);
    const bool inside = (body.low.head<2>().array() > area.low.head<2>().array()).all() &&
                        (body.high.head<2>().array() < area.high.head<2>().array()).all();
    if (inside) return Pose{node.pose.position + Vec3(0, 0, area.high.z() + kRestGap_m), node.pose.rotation};
  }
  return node.pose;
}

/// Pieces in the room that others stand next to in a row: on the floor, their backs to a wall.
std::vector<std::size_t> row_mates(const Workspace& workspace, std::size_t room) {
  std::vector<std::size_t> mates;
  const Scene& scene = workspace.scene();
  for (const std::size_t i : workspace.nodes_in(room)) {
    const Node& node = scene.nodes[i];
    const bool in_rows = node.archetype == Archetype::Block || node.archetype == Archetype::Cabinet ||
                         node.archetype == Archetype::Drawers || node.archetype == Archetype::Basin;
    if (!in_rows || node.movable || node.size.x() < 0.4 || node.pose.position.z() > node.size.z() / 2 + 0.01) continue;
    mates.push_back(i);
  }
  return mates;
}

/// The pieces in the room that it may stand by.
std::vector<std::size_t> company_in(const Workspace& workspace, std::size_t room, const FurniturePosition& where) {
  using enum FurniturePosition::Kind;
  if (where.kind == Wall || where.kind == Run) return row_mates(workspace, room);
  const bool alone = where.kind == Corner || where.kind == WallHung || where.kind == OuterWall ||
                     where.kind == Ceiling || where.kind == Center;
  return alone ? std::vector<std::size_t>() : hosts_in(workspace, room, where.host);
}

bool stands_free(const Node& piece, const Bounds& room) {
  const Bounds box = bounds_of(piece.pose, piece.size);
  return ((box.low - room.low).head<2>().array() > kFreeSide_m).all() &&
         ((room.high - box.high).head<2>().array() > kFreeSide_m).all();
}

/// Around what stands free, facing it, at one of the places along its sides; else before it.
Pose draw_seat(const Node& host, const Node& node, bool free, Rng& rng) {
  const Vec3 half = host.size / 2, own = node.size / 2;
  const auto places = [&](int along) {
    const double each = node.size.x() + kBetweenSeats_m;
    return std::max(1, static_cast<int>((2 * half[along] + kBetweenSeats_m) / each));
  };
  const int at_back_or_front = places(0), at_a_side = free ? places(1) : 0;
  const std::array<double, 4> weights{double(at_back_or_front), double(at_a_side), double(free ? at_back_or_front : 0),
                                      double(at_a_side)};
  const Vec2 outward = -inward_normal(rng.weighted(weights));  // side 0 has its wall at the low y, which is the front
  const int across = outward.x() != 0 ? 0 : 1, along = 1 - across;
  const int count = places(along);
  const double slot = 2 * half[along] / count;
  Vec3 spot;
  spot[across] = outward[across] * (half[across] + own.y() + rng.uniform(0.04, 0.1));
  spot[along] = (static_cast<double>(rng.below(static_cast<std::uint64_t>(count))) + 0.5) * slot - half[along];
  spot.z() = own.z() - host.pose.position.z();
  return host.pose * upright(spot, yaw_facing(-outward));
}

/// At the wall that a piece looks at, in its middle; nullopt when it looks at none straight.
std::optional<Pose> opposite(const Node& host, const Bounds& room, const Node& node, double bottom, Rng& rng) {
  const Vec2 front = (host.pose.rotation * Vec3(0, -1, 0)).head<2>();
  for (std::uint64_t side = 0; side < 4; ++side) {
    if (inward_normal(side).dot(front) > -0.99) continue;
    const WallStretch wall = whole_wall(room, side);
    const double least = kFromWall_m + node.size.x() / 2, space = wall.to - wall.from - 2 * least;
    const double at = host.pose.position[side % 2 == 0 ? 0 : 1] + rng.uniform(-kAside_m, kAside_m) - wall.from - least;
    if (space <= 0 || at < 0 || at > space) return std::nullopt;
    return at_wall(room, wall, at / space, node, bottom);
  }
  return std::nullopt;
}

std::optional<Candidate> draw_at_host(const Workspace& workspace, std::size_t room,
                                      const std::vector<std::size_t>& hosts, const Node& node,
                                      const FurniturePosition& where, Rng& rng) {
  if (hosts.empty()) return std::nullopt;
  const std::size_t index = rng.pick(hosts);
  const Node& host = workspace.scene().nodes[index];
  const Vec3 half = host.size / 2, own = node.size / 2;
  const double on_floor = own.z() - host.pose.position.z();
  if (where.kind == FurniturePosition::Kind::On) {
    const auto spot = draw_on_top(host, node, rng);
    if (!spot) return std::nullopt;
    return Candidate{host.pose * Pose{*spot, Quat::Identity()}, index};
  }
  if (where.kind == FurniturePosition::Kind::Above) {
    const double most = std::max(0.0, half.x() - own.x());
    const Vec3 spot(rng.uniform(-0.3, 0.3) * most, half.y() - own.y(),
                    half.z() + where.height_m.value_or(0.02) + own.z());
    return Candidate{host.pose * Pose{spot, Quat::Identity()}, index};
  }
  if (where.kind == FurniturePosition::Kind::Beside)
    return Candidate{beside(host, node, kNeighbor_m, rng, where.height_m.value_or(0)), index};
  if (where.kind == FurniturePosition::Kind::Before) {
    const double aside = rng.uniform(-0.5, 0.5) * std::max(0.0, half.x() - own.x());
    const double gap = covers_the_floor(node) ? rng.uniform(0.05, 0.15) : rng.uniform(0.35, 0.5);
    const Vec3 spot(aside, -half.y() - own.y() - gap, on_floor);
    return Candidate{host.pose * Pose{spot, Quat::Identity()}, index};
  }
  const Bounds bounds = room_bounds(workspace.scene().rooms[room], workspace.scene().wall_height);
  if (where.kind == FurniturePosition::Kind::Facing) {
    const auto pose = opposite(host, bounds, node, where.height_m.value_or(0), rng);
    if (!pose) return std::nullopt;
    return Candidate{*pose, std::nullopt};
  }
  return Candidate{draw_seat(host, node, stands_free(host, bounds), rng), index};
}

/// `company`: company_in that room.
std::optional<Candidate> draw_candidate(const Workspace& workspace, std::size_t room, const Node& node,
                                        const FurniturePosition& where, const std::vector<std::size_t>& company,
                                        Rng& rng) {
  const Scene& scene = workspace.scene();
  const Bounds bounds = room_bounds(scene.rooms[room], scene.wall_height);
  const auto against = [&](const WallStretch& wall, double share, double bottom) -> std::optional<Candidate> {
    const auto pose = at_wall(bounds, wall, share, node, bottom);
    if (!pose) return std::nullopt;
    return Candidate{*pose, std::nullopt};
  };
  switch (where.kind) {
    case FurniturePosition::Kind::Wall:
      if (rng.chance(kInRow) && !company.empty())
        return Candidate{beside(scene.nodes[rng.pick(company)], node, kNeighbor_m, rng), std::nullopt};
      return against(whole_wall(bounds, rng.below(4)), rng.unit(), 0);
    case FurniturePosition::Kind::Run:
      if (rng.chance(kInRun) && !company.empty())
        return Candidate{beside(scene.nodes[rng.pick(company)], node, kInRun_m, rng), std::nullopt};
      return against(whole_wall(bounds, rng.below(4)), rng.chance(0.5) ? 0.0 : 1.0, 0);
    case FurniturePosition::Kind::Corner:
      return against(whole_wall(bounds, rng.below(4)), rng.chance(0.5) ? 0.0 : 1.0, 0);
    case FurniturePosition::Kind::WallHung:
      return against(whole_wall(bounds, rng.below(4)), rng.unit(),
                     where.height_m.value_or(default_height(node, scene.wall_height)));
    case FurniturePosition::Kind::OuterWall: {
      const auto walls = outer_walls(scene.rooms, room);
      if (walls.empty()) return std::nullopt;
      return against(rng.pick(walls), rng.unit(), where.height_m.value_or(default_height(node, scene.wall_height)));
    }
    case FurniturePosition::Kind::Ceiling: {
      const Vec2 middle = ((bounds.low + bounds.high) / 2).head<2>();
      const Vec2 off(rng.uniform(-0.5, 0.5), rng.uniform(-0.5, 0.5));
      const double height = scene.wall_height - node.size.z() / 2 - kUnderCeiling_m;
      return Candidate{upright({middle.x() + off.x(), middle.y() + off.y(), height}, 0), std::nullopt};
    }
    case FurniturePosition::Kind::Center: {
      const double yaw = static_cast<double>(rng.below(4)) * std::numbers::pi / 2;
      const Bounds own = bounds_of(upright(Vec3::Zero(), yaw), node.size);
      Vec3 position(0, 0, node.size.z() / 2);
      for (int axis = 0; axis < 2; ++axis) {
        const double low = bounds.low[axis] - own.low[axis] + kAisle_m;
        const double high = bounds.high[axis] - own.high[axis] - kAisle_m;
        if (low > high) return std::nullopt;
        position[axis] = rng.uniform(low, high);
      }
      return Candidate{upright(position, yaw), std::nullopt};
    }
    default:
      return draw_at_host(workspace, room, company, node, where, rng);
  }
}

/// Room in front of a piece, in W.
Bounds front_of(const Node& node, double depth) {
  const Vec3 center(0, -node.size.y() / 2 - depth / 2, kPassage_m / 2 - node.pose.position.z());
  return bounds_of(node.pose * Pose{center, Quat::Identity()}, {node.size.x(), depth, kPassage_m - 0.02});
}

bool needs_front(const Node& node) {
  const double bottom = node.pose.position.z() - node.size.z() / 2;
  return bottom < 0.9 && node.archetype != Archetype::Panel && node.archetype != Archetype::Fixture;
}

/// Such as a coffee machine or a burner.
bool treats_what_is_on_it(const Knowledge& knowledge, const std::string& category) {
  for (const Treatment treatment : {Treatment::Fills, Treatment::Heats, Treatment::Cooks, Treatment::Burns}) {
    const auto effects = knowledge.effects_of(category, treatment);
    if (std::any_of(effects.begin(), effects.end(),
                    [](const Effect* effect) { return has_need(*effect, EffectNeed::On); }))
      return true;
  }
  return false;
}

Bounds above(const Node& node) {
  const Bounds body = bounds_of(node.pose, node.size);
  return {{body.low.x(), body.low.y(), body.high.z()}, {body.high.x(), body.high.y(), body.high.z() + kAbove_m}};
}

/// The keep-outs that a placed piece brings with it; `sweep`: where its doors and drawers pass.
std::vector<Bounds> own_keep_outs(const Knowledge& knowledge, const Node& node, const std::optional<Bounds>& sweep,
                                  bool with_front, const FurnishOptions& options) {
  std::vector<Bounds> spaces;
  if (treats_what_is_on_it(knowledge, node.category)) spaces.push_back(above(node));
  if (with_front && needs_front(node)) {
    spaces.push_back(front_of(node, node.openable ? options.clearance_open_m : options.clearance_m));
  }
  if (sweep) spaces.push_back(*sweep);
  return spaces;
}

bool backs_onto_a_wall(FurniturePosition::Kind kind) {
  return kind == FurniturePosition::Kind::Wall || kind == FurniturePosition::Kind::Run ||
         kind == FurniturePosition::Kind::Corner || kind == FurniturePosition::Kind::Facing ||
         kind == FurniturePosition::Kind::WallHung || kind == FurniturePosition::Kind::OuterWall ||
         kind == FurniturePosition::Kind::Beside;
}

bool within(const Bounds& inner, const Bounds& room) {
  for (int axis = 0; axis < 2; ++axis) {
    if (inner.low[axis] < room.low[axis] + kFurnitureMargin_m ||
        inner.high[axis] > room.high[axis] - kFurnitureMargin_m) {
      return false;
    }
  }
  return inner.low.z() > -1e-9 && inner.high.z() < room.high.z();
}

/// A door at a few of its positions. What the piece stands on is just under the door and does not count.
bool opens_freely(const Workspace& workspace, const Node& node, const Shape& shape, std::optional<std::size_t> host) {
  if (shape.joints.empty()) return true;
  std::vector<BodyId> ignore;
  if (host) ignore.push_back(BodyId::node(*host));
  for (int k = 1; k <= 4; ++k) {
    if (workspace.checker().hit_by_joints(shape, node.pose, k / 4.0, kGap_m / 2, ignore)) return false;
  }
  return true;
}

/// The cheap part: in the room and in no space that has to stay free.
bool keeps_out(const std::vector<KeepOut>& keep_outs, const Bounds& room, const Bounds& body,
               std::optional<std::size_t> host) {
  if (!within(body, room)) return false;
  return std::none_of(keep_outs.begin(), keep_outs.end(), [&](const KeepOut& keep_out) {
    return !(keep_out.owner && keep_out.owner == host) && overlap(keep_out.space, body, kGap_m);
  });
}

/// Whether chairs would find room around what stands in the middle, or before a table or desk at a wall.
bool has_room_for_seats(const std::vector<KeepOut>& keep_outs, const Node& table, FurniturePosition::Kind where) {
  const bool at_wall = where == FurniturePosition::Kind::Wall && table.archetype == Archetype::Table;
  if (where != FurniturePosition::Kind::Center && (!at_wall || table.size.x() < kDesk_m)) return true;
  Bounds around = at_wall ? front_of(table, kSeat_m) : bounds_of(table.pose, table.size);
  if (!at_wall) {
    around.low.head<2>().array() -= kSeat_m;
    around.high.head<2>().array() += kSeat_m;
  }
  return std::none_of(keep_outs.begin(), keep_outs.end(),
                      [&](const KeepOut& keep_out) { return overlap(keep_out.space, around); });
}

/// The costly checks: what it needs free is free, it touches nothing and its doors open.
bool fits(const Workspace& workspace, const Bounds& room, const Node& node, const Shape& shape,
          std::optional<std::size_t> host, const std::vector<Bounds>& own_spaces) {
  const SharedList<Bounds>& standing = workspace.bounds();
  for (const Bounds& space : own_spaces) {
    if (!within({space.low.cwiseMax(Vec3(-1e9, -1e9, 0)), space.high}, room)) return false;
    for (const BodyId near : workspace.physics().near(space, kGap_m)) {
      const std::size_t i = near.index();
      if (!near.is_node() || i >= standing.size() || host == i || !overlap(space, standing[i])) continue;
      if (!covers_the_floor(workspace.scene().nodes[i])) return false;
    }
  }
  return !workspace.checker().hit(shape, node.pose, 0, host ? PlacementChecker::kGap_m : kGap_m) &&
         opens_freely(workspace, node, shape, host);
}

}  // namespace

std::vector<KeepOut> keep_outs_at_openings(const Scene& scene) {
  std::vector<KeepOut> keep_outs;
  for (const Opening& opening : scene.openings) {
    const Vec2 low = opening.from.cwiseMin(opening.to), high = opening.from.cwiseMax(opening.to);
    const bool along_x = high.x() - low.x() > high.y() - low.y();
    const Vec2 depth = along_x ? Vec2(0.05, kDoorwayDepth_m) : Vec2(kDoorwayDepth_m, 0.05);
    keep_outs.push_back(
        {{{low.x() - depth.x(), low.y() - depth.y(), 0}, {high.x() + depth.x(), high.y() + depth.y(), opening.height}},
         std::nullopt});
  }
  return keep_outs;
}

KeepOut keep_out_at_entrance(const Scene& scene) {
  const auto entrance = entrance_of(scene.rooms);
  if (!entrance) return {};
  const Vec2 along = kOpeningWidth_m / 2 * Vec2(entrance->inward.y(), entrance->inward.x());
  const Vec2 a = entrance->at - along, b = entrance->at + along + kDoorwayDepth_m * entrance->inward;
  const Vec2 low = a.cwiseMin(b), high = a.cwiseMax(b);
  return {{{low.x(), low.y(), 0}, {high.x(), high.y(), kPassage_m}}, std::nullopt};
}

std::vector<KeepOut> keep_outs_of(const Workspace& workspace, const FurnishOptions& options, std::size_t room) {
  const Scene& scene = workspace.scene();
  std::vector<KeepOut> keep_outs = keep_outs_at_openings(scene);
  const Bounds bounds = room_bounds(scene.rooms[room], scene.wall_height);
  std::erase_if(keep_outs, [&](const KeepOut& one) { return !overlap(one.space, bounds, kFarthestKeepOut_m); });
  for (const std::size_t i : nodes_near(workspace, room, kFarthestKeepOut_m)) {
    if (scene.nodes[i].movable) continue;
    // The front of what stands free is not known to be needed: only pieces with their back near a wall keep it.
    const bool front = scene.nodes[i].openable || scene.nodes[i].archetype == Archetype::Block;
    for (const Bounds& space :
         own_keep_outs(workspace.knowledge(), scene.nodes[i], workspace.sweeps()[i], front, options))
      keep_outs.push_back({space, i});
  }
  return keep_outs;
}

bool place_furniture(Workspace& workspace, std::vector<KeepOut>& keep_outs, std::size_t room, Node node,
                     const FurniturePosition& where, const FurnishOptions& options, Rng rng) {
  const Bounds bounds = room_bounds(workspace.scene().rooms[room], workspace.scene().wall_height);
  const Shape shape = shape_of(node);
  const auto company = company_in(workspace, room, where);
  for (int draw = 0; draw < options.draws; ++draw) {
    const auto candidate = draw_candidate(workspace, room, node, where, company, rng);
    if (!candidate) continue;
    node.pose = candidate->pose;
    node.pose = on_its_rug(workspace, room, node);
    const bool rug = covers_the_floor(node);  // nobody minds one before a cupboard
    const Bounds body = bounds_of(shape, node.pose, 0);
    if (rug ? !within(body, bounds) : !keeps_out(keep_outs, bounds, body, candidate->host)) continue;
    if (!has_room_for_seats(keep_outs, node, where.kind)) continue;
    const auto spaces =
        own_keep_outs(workspace.knowledge(), node, sweep_of(node), backs_onto_a_wall(where.kind), options);
    if (!fits(workspace, bounds, node, shape, candidate->host, spaces)) continue;
    const std::size_t index = workspace.add(std::move(node));
    for (const Bounds& space : spaces) keep_outs.push_back({space, index});
    return true;
  }
  return false;
}

}  // namespace unietp
