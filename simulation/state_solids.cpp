#include "simulation/state_solids.h"

#include <algorithm>
#include <string>

#include "simulation/finish.h"
#include "simulation/plug_solids.h"
#include "simulation/shape.h"

namespace unietp {
namespace {

/// Collects solids in an object's frame.
class Extras {
 public:
  Extras(const Node& node, std::int32_t owner, std::vector<Solid>& solids)
      : half(node.size / 2), node_(node), owner_(owner), solids_(solids) {}

  void add(SolidKind kind, const Vec3& center, const Vec3& size, Skin skin) {
    solids_.push_back({kind, node_.pose * Pose{center, Quat::Identity()}, size, owner_, false, skin});
  }
  void box(const Vec3& center, const Vec3& size, Skin skin) { add(SolidKind::Box, center, size, skin); }
  void pillar(const Vec3& top, double length, double wide, Skin skin) {
    add(SolidKind::Cylinder, top - Vec3(0, 0, length / 2), {wide, wide, length}, skin);
  }
  const Vec3 half;

 private:
  const Node& node_;
  std::int32_t owner_;
  std::vector<Solid>& solids_;
};

/// Nearer to the rim in what is narrow and deep, so that it is seen from where people look in.
double level_in(double level, double wide, double tall) { return std::max(level, 1 - 0.12 * wide / tall); }

/// The lower part of the hollow of a cup or crate.
Solid filling_of(const Solid& vessel, double full) {
  const Vec3 half = vessel.axes.colwise().norm();
  const double level = level_in(full, half.head<2>().minCoeff(), half.z());
  constexpr double kInside = 0.985;  // of the hollow's width
  const double bottom = -1 + vessel.floor, top = bottom + level * (1 - bottom);
  const Vec2 wall = Vec2::Constant(vessel.wall);
  const Vec2 low = vessel.low + (vessel.high - vessel.low) * vessel.floor / 2 - wall, high = vessel.high - wall;
  Solid filling = vessel;
  filling.kind = vessel.kind == SolidKind::Cup ? SolidKind::Cone : SolidKind::Wedge;
  filling.skin = Skin::Liquid;
  filling.clear = true;
  filling.low = kInside * low;
  filling.high = kInside * (low + level * (high - low));
  filling.axes.col(2) *= (top - bottom) / 2;
  filling.pose.position += (top + bottom) / 2 * vessel.axes.col(2);
  filling.color.reset();
  filling.matter.reset();
  return filling;
}

void add_liquid(const Shape& shape, double level, double opening, std::size_t first, std::vector<Solid>& solids,
                Extras& extras) {
  for (std::size_t i = first; i < solids.size(); ++i) {
    if (solids[i].kind != SolidKind::Cup && solids[i].kind != SolidKind::Crate) continue;
    solids.push_back(filling_of(solids[i], level));
    return;
  }
  if (first < solids.size() && solids[first].sheared) return;  // its shape shows no hollow: a level on the outside does
  for (const Cavity& cavity : shape.cavities) {
    if (!cavity.open_above || cavity.joint >= 0 || (cavity.closable && opening == 0)) continue;
    const double full = level_in(level, cavity.half.head<2>().minCoeff(), cavity.half.z());
    const Vec3 size(2 * cavity.half.x(), 2 * cavity.half.y(), 2 * full * cavity.half.z());
    extras.box(cavity.center - Vec3(0, 0, cavity.half.z() * (1 - full)), size, Skin::Liquid);
    solids.back().clear = true;
  }
}

/// From a spout, in front of a tap, or as a rain below a shower head.
void add_water(const Node& node, const Shape& shape, Extras& extras) {
  const Vec3& h = extras.half;
  if (!shape.cavities.empty()) {
    const Cavity& bowl = shape.cavities.front();
    constexpr double kSpout_m = 0.22, kPipe_m = 0.03;
    const Vec3 foot(0, bowl.center.y() + 0.8 * bowl.half.y(), h.z());
    const double reach = 0.8 * bowl.half.y();
    extras.pillar(foot + Vec3(0, 0, kSpout_m), kSpout_m, kPipe_m, Skin::Socket);
    extras.box(foot + Vec3(0, -reach / 2, kSpout_m), {kPipe_m, reach + kPipe_m, kPipe_m}, Skin::Socket);
    extras.pillar(foot + Vec3(0, -reach, kSpout_m), kSpout_m + 1.8 * bowl.half.z(), kPipe_m, Skin::Water);
    return;
  }
  if (node.category.find("hower") != std::string::npos) {
    constexpr double kFall_m = 0.8;
    for (const int row : {-1, 0, 1}) {
      for (const int column : {-1, 0, 1})
        extras.pillar({column * 0.6 * h.x(), row * 0.6 * h.y(), -h.z()}, kFall_m, 0.012, Skin::Water);
    }
    return;
  }
  const double wide = std::clamp(0.3 * h.x(), 0.014, 0.05);
  extras.pillar({0, -h.y() - wide / 2, 0.6 * h.z()}, 1.6 * h.z(), wide, Skin::Water);
}

void add_flame(Extras& extras) {
  const double wide = std::clamp(extras.half.head<2>().minCoeff(), 0.012, 0.05);
  const double top = extras.half.z();
  extras.add(SolidKind::Sphere, {0, 0, top + wide / 2}, Vec3::Constant(wide), Skin::Flame);
  extras.add(SolidKind::Sphere, {0, 0, top + 1.15 * wide}, Vec3::Constant(0.7 * wide), Skin::Flame);
  extras.add(SolidKind::Sphere, {0, 0, top + 1.6 * wide}, Vec3::Constant(0.4 * wide), Skin::Flame);
}

/// The flap that was over what stands open, and a dark mouth below it on what shows no hollow.
void add_flap(bool hollow, Extras& extras) {
  const Vec3& h = extras.half;
  const double thin = std::clamp(0.04 * h.minCoeff(), 0.001, 0.01);
  if (!hollow) extras.box({0, 0, h.z()}, {1.7 * h.x(), 1.7 * h.y(), 2 * thin}, Skin::Mouth);
  extras.box({0, h.y(), h.z() + 0.8 * h.y()}, {1.9 * h.x(), 3 * thin, 1.6 * h.y()}, Skin::Flap);
}

}  // namespace

double reach_of_states(const Node& node) {
  constexpr double kCord_m = 0.5, kFall_m = 0.8, kFlap = 0.9;  // of the depth
  double reach = 0;
  for (const State& state : node.states.all()) {
    if (state.predicate == Predicate::PluggedIn || state.predicate == Predicate::Unplugged)
      reach = std::max(reach, kCord_m);
    if (state.predicate == Predicate::PowerOn) reach = std::max(reach, kFall_m);
    if (state.predicate == Predicate::Open) reach = std::max(reach, kFlap * node.size.y());
  }
  return reach;
}

void add_state_solids(const Node& node, std::int32_t owner, std::size_t first, bool shows_open,
                      std::span<const WallPiece> walls, std::vector<Solid>& solids) {
  const Look look = look_of(node);
  const bool taps = look.on && look.device == Device::Tap, open = node.states.has(Predicate::Open);
  add_plug_solids(node, owner, walls, solids);
  if (look.level <= 0 && !taps && !open && !look.on) return;
  Extras extras(node, owner, solids);
  const Shape shape = shape_of(node);
  if (look.level > 0) add_liquid(shape, look.level, node.opening, first, solids, extras);
  if (taps) add_water(node, shape, extras);
  if (look.on && look.device == Device::Flame) add_flame(extras);
  const auto any = [&](auto is) {
    return std::any_of(solids.begin() + static_cast<std::ptrdiff_t>(first), solids.end(), is);
  };
  const bool swings = any([](const Solid& solid) { return solid.moves; });
  const auto is_hollow = [](const Solid& solid) {
    return solid.kind == SolidKind::Cup || solid.kind == SolidKind::Crate;
  };
  if (open && !shows_open && !swings) add_flap(any(is_hollow), extras);
}

}  // namespace unietp
