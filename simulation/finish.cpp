#include "simulation/finish.h"

#include <algorithm>
#include <cmath>

#include "simulation/noise.h"

namespace unietp {
namespace {

/// How much of a pattern with this many lines a meter can be seen: less, the nearer a line is to a pixel's width.
double seen(const SurfacePoint& point, double lines) { return std::clamp(1.6 - 3 * lines * point.pixel_m, 0.0, 1.0); }

/// The longest side of the body that lies in the face of the point: an axis.
Vec3::Index grain_of(const Look& look, const SurfacePoint& point) {
  Vec3::Index face = 0, along = 0;
  point.normal.cwiseAbs().maxCoeff(&face);
  Vec3 sides = look.half;
  sides[face] = 0;
  sides.maxCoeff(&along);
  return along;
}

/// Boards with rings, along the longest side of a face.
void wood(const Look& look, const SurfacePoint& point, Finish& finish) {
  const Vec3::Index along = grain_of(look, point);
  Vec3 stretched = 30 * point.at;
  stretched[along] /= 14;
  const double rings = noise(stretched, look.seed), streak = wave(2.2 * rings + 0.3 * stretched.sum());
  const double share = 0.35 + 0.65 * seen(point, 20);
  finish.color *= 1 - share * (0.22 * ramp(0.35, 0.95, streak) + 0.12 * (1 - rings));
  finish.gloss = 0.12;
}

/// Brushed along the longest side of a face.
void metal(const Look& look, const SurfacePoint& point, Finish& finish) {
  const Vec3::Index along = grain_of(look, point);
  Vec3 stretched = 420 * point.at;
  stretched[along] /= 60;
  finish.color *= 1 - 0.16 * seen(point, 160) * noise(stretched, look.seed);
  finish.gloss = 0.85;
}

/// Threads over and under each other.
void fabric(const SurfacePoint& point, Finish& finish) {
  constexpr double kThreads = 130;  // a meter
  const Vec3 thread = kThreads * point.at;
  const double weave = wave(thread.x() + thread.z()) * 0.5 + wave(thread.y() - thread.z()) * 0.5;
  finish.color *= 1 - 0.26 * seen(point, kThreads) * weave;
  constexpr double kRibs = 40;
  finish.color *= 1 - 0.2 * seen(point, kRibs) * wave(kRibs * (point.at.x() + 0.7 * point.at.y() + point.at.z()));
}

void stone(const Look& look, const SurfacePoint& point, Finish& finish) {
  const double speck = noise(180 * point.at, look.seed), vein = rough_noise(7 * point.at, look.seed + 5);
  finish.color *= 0.9 + 0.3 * seen(point, 90) * (speck - 0.5);
  if (std::abs(vein - 0.5) < 0.03) finish.color *= 0.78;
  finish.gloss = 0.2;
}

void wicker(const SurfacePoint& point, Finish& finish) {
  const Vec3 strand = 45 * point.at;
  const int row = static_cast<int>(std::floor(strand.z())),
            column = static_cast<int>(std::floor(strand.x() + strand.y()));
  const double round = (row + column) % 2 == 0 ? wave(strand.z()) : wave(strand.x() + strand.y());
  finish.color *= 1 - 0.5 * seen(point, 45) * (1 - round);
}

void paper(const SurfacePoint& point, Finish& finish) { finish.color *= 0.96 + 0.06 * noise(70 * point.at, 9); }

/// Flutes across the edges and a fold.
void cardboard(const SurfacePoint& point, Finish& finish) {
  finish.color *= 0.93 + 0.1 * noise(Vec3(15 * point.at.x(), 15 * point.at.y(), 240 * point.at.z()), 4);
  const double lines = 110;
  finish.color *= 1 - 0.14 * seen(point, lines) * wave(lines * (point.at.x() + point.at.y()));
  if (std::abs(point.inner.x()) < 0.12 && point.normal.z() > 0.9)
    finish.color = mixed(finish.color, {214, 190, 140}, 0.5);
}

void food(const Look& look, const SurfacePoint& point, Finish& finish) {
  const double spot = rough_noise(9 * look.grain * point.at, look.seed);
  finish.color = mixed(finish.color * 0.82, finish.color * 1.12, spot);
  finish.gloss = 0.15;
}

}  // namespace

Finish matter_finish(const Look& look, const SurfacePoint& point) {
  Finish finish{look.base};
  switch (look.matter) {
    case Matter::Wood:
      wood(look, point, finish);
      break;
    case Matter::Metal:
      metal(look, point, finish);
      break;
    case Matter::Glass:
      finish.gloss = 0.9;
      finish.clear = 0.6;
      break;
    case Matter::Fabric:
      fabric(point, finish);
      break;
    case Matter::Leather:
      finish.color *= 0.8 + 0.22 * ramp(0.02, 0.25, cell_at(90 * point.at, look.seed).to_border);
      finish.gloss = 0.3;
      break;
    case Matter::Stone:
      stone(look, point, finish);
      break;
    case Matter::Wicker:
      wicker(point, finish);
      break;
    case Matter::Paper:
      paper(point, finish);
      break;
    case Matter::Cardboard:
      cardboard(point, finish);
      break;
    case Matter::Foam:
      finish.color *= 0.75 + 0.3 * ramp(0.1, 0.5, cell_at(110 * point.at, look.seed).to_middle);
      break;
    case Matter::Food:
      food(look, point, finish);
      break;
    case Matter::Ceramic:
      finish.color *= 0.98 + 0.04 * noise(12 * point.at, look.seed);
      finish.gloss = 0.6;
      break;
    case Matter::Plastic:
      finish.gloss = 0.35;
      break;
    case Matter::Wax:
    case Matter::Plain:
      finish.gloss = 0.15;
      break;
    case Matter::Rubber:
      finish.color *= 0.94 + 0.1 * noise(300 * point.at, look.seed);
      break;
  }
  return finish;
}

namespace {

/// The outdoors behind a window: sky, trees and grass, by height.
Color outdoors(const Look& look, const SurfacePoint& point) {
  const double across = look.half.x() >= look.half.y() ? point.at.x() : point.at.y();
  const double tree = -0.35 + 0.5 * rough_noise(Vec3(4 * across, 0, 0), look.seed);
  const double z = point.inner.z();
  if (z > tree) return mixed({226, 238, 246}, {120, 176, 232}, ramp(-0.3, 1, z));
  if (z > -0.55) return Color(74, 122, 66) * (0.8 + 0.4 * noise(Vec3(22 * across, 0, 22 * point.at.z()), 2));
  return {134, 172, 92};
}

/// A frame and a cross of bars before the outdoors.
Finish window_finish(const Look& look, const SurfacePoint& point) {
  const double across = look.half.x() >= look.half.y() ? point.inner.x() : point.inner.y();
  const double z = point.inner.z();
  const bool bar = std::max(std::abs(across), std::abs(z)) > 0.92 || std::abs(across) < 0.04 || std::abs(z) < 0.03;
  if (bar) return {Color(236, 234, 228), 0.2};
  return {outdoors(look, point), 0, 0, true};
}

Color skin_color(const Look& look, const SurfacePoint& point) {
  switch (point.skin) {
    case Skin::Water:
      return mixed({150, 200, 240}, {236, 246, 252},
                   noise(Vec3(90 * point.at.x(), 90 * point.at.y(), 26 * point.at.z()), 1));
    case Skin::Flame:
      return mixed({255, 236, 150}, {255, 150, 30}, (point.inner.z() + 1) / 2);
    case Skin::Cord:
    case Skin::Plug:
      return {34, 34, 38};
    case Skin::Socket:
      return {246, 246, 242};
    case Skin::Mouth:
      return look.base * 0.16;
    case Skin::Liquid:
      return shown_filling(look);
    case Skin::Flap:
    case Skin::Body:
      break;
  }
  return look.base;
}

}  // namespace

Finish finish_of(const Look& look, const SurfacePoint& point) {
  if (point.skin == Skin::Body || point.skin == Skin::Flap) {
    if (look.window) {
      Finish finish = window_finish(look, point);
      show_states(look, point, finish);
      return finish;
    }
    Finish finish = matter_finish(look, point);
    show_states(look, point, finish);
    return finish;
  }
  Finish finish{skin_color(look, point)};
  finish.gloss = point.skin == Skin::Liquid || point.skin == Skin::Water ? 0.8 : 0.2;
  finish.glows = point.skin == Skin::Flame;
  if (point.skin == Skin::Liquid) finish.clear = 0.15;  // what lies in it is seen
  return finish;
}

}  // namespace unietp
