#pragma once

#include "shapes/device.h"
#include "simulation/paint.h"
#include "simulation/solid.h"

namespace unietp {

/// What an object's looks depend on, computed once a picture.
struct Look {
  Color base = Color::Zero();
  Matter matter = Matter::Plain;
  Device device = Device::None;
  std::uint32_t seed = 0;
  Vec3 half = Vec3::Zero();  // half extents of the body, meters
  double grain = 1;          // stains and frost a meter: more on small things
  bool on = false, dirty = false, soaked = false, hot = false, cool = false, cooked = false, burnt = false;
  bool frozen = false, cut = false, used_up = false, broken = false, folded = false, unfolded = false;
  bool folds_up = false;              // two slabs on a hinge
  bool window = false;                // the outdoors is seen through it
  double level = 0;                   // of its filling, in parts of its height; 0: empty
  bool pool = false;                  // its filling is a solid of its own, in a hollow
  Color filling = Color::Zero();      // of what fills it
  Color cover = Color::Constant(-1);  // of what covers it; negative: nothing
};
/// `family`: the shape that it is seen as, or nullptr.
Look look_of(const Node& node, const ShapeFamily* family = nullptr);

/// Whether the outdoors is seen through it.
bool is_window(const Node& node);

/// A point of an object's surface.
struct SurfacePoint {
  Vec3 at = Vec3::Zero();      // object frame, meters; of doors and lids: their own frame
  Vec3 normal = Vec3::Zero();  // in the same frame, unit
  Vec3 inner = Vec3::Zero();   // in parts of the half extents of its solid, each in [-1, 1]
  Skin skin = Skin::Body;
  bool moves = false;  // of a door, lid or drawer
  double pixel_m = 0;  // what one pixel covers, meters: finer patterns are left out
};

/// What light does at a point.
struct Finish {
  Color color = Color::Zero();  // 0 to 255, before light
  double gloss = 0;             // share of the lamp's reflection, 0 (cloth) to 1 (glass)
  double clear = 0;             // share of what is behind it that is seen
  bool glows = false;           // needs no light
};

/// Material, states and filling of a point.
Finish finish_of(const Look& look, const SurfacePoint& point);

/// Material alone: grain, weave, speckles (finish_of begins with it).
Finish matter_finish(const Look& look, const SurfacePoint& point);
/// Adds what the states of the object change.
void show_states(const Look& look, const SurfacePoint& point, Finish& finish);

/// The color of what fills it, lighter or darker where it is too near to that of the body or of its hollow.
Color shown_filling(const Look& look);

/// The color this share of the way from `a` to `b`.
inline Color mixed(const Color& a, const Color& b, double share) { return a + share * (b - a); }

}  // namespace unietp
