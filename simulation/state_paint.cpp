#include <algorithm>
#include <cmath>

#include "simulation/finish.h"
#include "simulation/noise.h"

namespace unietp {
namespace {

constexpr double kDarkest = 110;  // what is darker gets light stains

double brightness(const Color& color) { return color.dot(Vec3(0.3, 0.59, 0.11)); }

void dirty(const Look& look, const SurfacePoint& point, Finish& finish) {
  const Color mud = brightness(look.base) < kDarkest ? Color(198, 172, 124) : Color(82, 58, 36);
  const double stain = rough_noise(look.grain * point.at, look.seed + 17);
  const double speck = noise(5 * look.grain * point.at, look.seed + 18);
  const double share = std::max(0.92 * ramp(0.46, 0.54, stain), 0.8 * ramp(0.78, 0.84, speck));
  finish.color = mixed(finish.color, mud, share);
  finish.gloss *= 1 - share;
  finish.clear *= 1 - share;
  finish.glows = finish.glows && share < 0.5;
}

/// A layer with gaps, thicker above.
void covered(const Look& look, const SurfacePoint& point, Finish& finish) {
  const auto apart = [&](const Color& color) { return (color - look.base).cwiseAbs().maxCoeff(); };
  Color cover = look.cover;
  if (apart(cover) < 85) {
    const Color darker = 0.5 * look.cover, lighter = (1.6 * look.cover).cwiseMin(255);
    cover = apart(darker) > apart(lighter) ? darker : lighter;
  }
  const double layer =
      rough_noise(1.6 * look.grain * point.at, look.seed + 29) + 0.16 * std::max(0.0, point.normal.z());
  const double share = 0.95 * ramp(0.36, 0.44, layer);
  finish.color = mixed(finish.color, cover * (0.9 + 0.2 * layer), share);
  finish.gloss *= 1 - 0.7 * share;
  finish.clear *= 1 - share;
}

/// Dark with water, with drops that shine.
void soaked(const Look& look, const SurfacePoint& point, Finish& finish) {
  const bool dark = brightness(look.base) < kDarkest;
  finish.color =
      dark ? mixed(finish.color, {88, 124, 168}, 0.45) : Color(finish.color.cwiseProduct(Vec3(0.44, 0.5, 0.6)));
  finish.gloss = 0.8;
  const CellAt drop = cell_at(4 * look.grain * point.at, look.seed + 31);
  if (drop.to_middle < 0.3) finish.color = mixed(finish.color, {214, 234, 250}, drop.to_middle < 0.16 ? 0.85 : 0.4);
}

void cold(const Look& look, const SurfacePoint& point, Finish& finish) {
  if (look.frozen) {  // frost with needles, almost all over
    const double frost = rough_noise(3 * look.grain * point.at, look.seed + 37);
    const double needle = cell_at(3.5 * look.grain * point.at, look.seed + 38).to_border;
    const Color ice = brightness(look.base) > 205 ? Color(150, 196, 236) : Color(234, 244, 253);
    finish.color = mixed(finish.color, ice, 0.5 + 0.4 * ramp(0.3, 0.6, frost));
    if (needle < 0.07) finish.color = {252, 254, 255};
    finish.gloss = 0.5;
    finish.clear = 0;
    return;
  }
  // A blue film with drops of condensed water.
  finish.color = mixed(finish.color, {108, 164, 226}, 0.62);
  const CellAt drop = cell_at(5 * look.grain * point.at, look.seed + 41);
  if (drop.to_middle < 0.24) finish.color = mixed(finish.color, {240, 248, 255}, 0.8);
  finish.clear *= 0.5;
}

/// A warm glow that rises from below; steam is added above (glow.h).
void hot(const SurfacePoint& point, Finish& finish) {
  finish.color = mixed(finish.color, {255, 92, 36}, 0.38 - 0.22 * ramp(-1, 1, point.inner.z()));
}

void cooked(const Look& look, const SurfacePoint& point, Finish& finish) {
  const double brown = rough_noise(1.5 * look.grain * point.at, look.seed + 43);
  const Color crust = brightness(look.base) < kDarkest ? Color(206, 138, 62) : Color(142, 84, 36);
  finish.color = mixed(finish.color, crust, 0.55 + 0.4 * brown);
  const double stripe = wave(1.1 * look.grain * (point.at.x() + point.at.y()));  // of the grill
  finish.color *= 1 - 0.55 * ramp(0.74, 0.86, stripe);
  finish.gloss = 0.4;
}

void burnt(const Look& look, const SurfacePoint& point, Finish& finish) {
  const double ash = noise(6 * look.grain * point.at, look.seed + 47);
  const double char_ = rough_noise(1.2 * look.grain * point.at, look.seed + 48);
  const bool dark = brightness(look.base) < 70;
  finish.color = mixed(finish.color, {22, 19, 18}, 0.8 + 0.18 * char_);
  if (ash > (dark ? 0.5 : 0.72)) finish.color = mixed(finish.color, {176, 172, 168}, dark ? 0.8 : 0.55);
  finish.gloss = 0;
}

/// Flesh with a rind around it on the sides, and lines of the blade above.
void cut(const Look& look, const SurfacePoint& point, Finish& finish) {
  Vec3::Index face = 0;
  point.normal.cwiseAbs().maxCoeff(&face);
  double rim = 0;
  for (Vec3::Index axis = 0; axis < 3; ++axis) {
    if (axis != face) rim = std::max(rim, std::abs(point.inner[axis]));
  }
  const Color flesh = brightness(look.base) > 190 ? Color(look.base.cwiseProduct(Vec3(0.78, 0.66, 0.42)))
                                                  : mixed(look.base, {252, 240, 196}, 0.72);
  if (face == 2) {
    finish.color = mixed(finish.color, flesh, 0.85 * ramp(0.3, 0.5, wave(1.5 * (point.inner.x() + point.inner.y()))));
  } else if (rim < 0.8) {
    const double pip = cell_at(3 * look.grain * point.at, look.seed + 53).to_middle;
    finish.color = pip < 0.2 ? Color(90, 62, 34) : Color(flesh * (0.93 + 0.1 * noise(6 * look.grain * point.at, 5)));
    finish.gloss = 0.4;
  }
}

/// Cracks with light edges; pieces are tilted, so each takes another light.
void broken(const Look& look, const SurfacePoint& point, Finish& finish) {
  const CellAt piece = cell_at(1.1 * look.grain * point.at, look.seed + 59);
  finish.color *= 0.62 + 0.6 * piece.number;
  const Color gap = brightness(look.base) < kDarkest ? Color(226, 226, 222) : Color(20, 18, 18);
  if (piece.to_border < 0.1) finish.color = gap;
  if (piece.to_border < 0.16) finish.clear = 0;
}

/// Layers on the sides and two creases above when folded; else wrinkles.
void folds(const Look& look, const SurfacePoint& point, Finish& finish) {
  if (look.folded) {
    const Color crease =
        brightness(look.base) < kDarkest ? mixed(look.base, {236, 236, 236}, 0.5) : Color(look.base * 0.4);
    const double layers = wave(2 * (point.inner.z() + 1) + 0.25);
    if (std::abs(point.normal.z()) < 0.5) finish.color = mixed(finish.color, crease, ramp(0.55, 0.85, layers));
    const bool right = point.inner.x() > 0, back = point.inner.y() > 0;
    if (right != back) finish.color = mixed(finish.color, crease, 0.35);
    if (std::min(std::abs(point.inner.x()), std::abs(point.inner.y())) < 0.05) finish.color = crease;
    return;
  }
  const double wrinkle = noise(Vec3(2.2, 0.9, 1.4).cwiseProduct(look.grain * point.at), look.seed + 61);
  finish.color *= 0.66 + 0.4 * wave(2.5 * wrinkle);
}

/// Faded and crumpled, with a dark hollow where the contents were.
void used_up(const Look& look, const SurfacePoint& point, Finish& finish) {
  const CellAt fold = cell_at(1.3 * look.grain * point.at, look.seed + 67);
  const Color faded = brightness(look.base) > 200 ? Color(150, 146, 138) : Color(206, 202, 194);
  finish.color = mixed(finish.color, faded, 0.75) * (0.72 + 0.36 * fold.number);
  if (point.normal.z() > 0.7 && point.inner.head<2>().squaredNorm() < 0.45) finish.color *= 0.22;
  finish.gloss = 0;
}

/// Of things whose shape has no hollow in which it stands: as through a round opening above, and of glass a level on
/// the outside.
void filled(const Look& look, const SurfacePoint& point, Finish& finish) {
  const double line = 2 * look.level - 1;
  const Color filling = shown_filling(look);
  if (finish.clear == 0) {
    constexpr double kOpening = 0.62, kRim = 0.74;
    const double away = point.inner.head<2>().norm();
    if (point.normal.z() < 0.25 || away > kRim) return;
    finish.color = away < kOpening ? filling : Color(finish.color * 0.6);
    if (away < kOpening) finish.gloss = 0.8;
    return;
  }
  if (point.inner.z() >= line) return;
  finish.color = mixed(finish.color, filling, 0.8);
  if (line - point.inner.z() < 0.07) finish.color = mixed(finish.color, {255, 255, 255}, 0.4);
  finish.clear *= 0.25;
}

/// Hills under a sun, as a picture on a screen; x and y in [-1, 1], y up.
Color shown_picture(double x, double y) {
  if ((Vec2(x, y) - Vec2(0.5, 0.5)).squaredNorm() < 0.05) return {255, 240, 140};
  if (y < -0.35 + 0.25 * wave(0.5 * x + 0.3)) return {86, 176, 84};
  if (y < 0.05 + 0.3 * wave(0.9 * x)) return {92, 118, 190};
  return mixed({255, 190, 130}, {96, 170, 250}, ramp(0, 1, y));
}

/// The face that shows: the larger of front and top; of a lid its lower face.
bool is_front(const Look& look, const SurfacePoint& point) {
  if (point.moves) return point.normal.z() < -0.7;
  return look.half.z() > 0.4 * look.half.y() ? point.normal.y() < -0.7 : point.normal.z() > 0.7;
}

/// Rows of keys before the lid of what folds.
void keyboard(const SurfacePoint& point, Finish& finish) {
  if (point.normal.z() < 0.7 || std::abs(point.inner.x()) > 0.9) return;
  const double y = point.inner.y();
  if (y > -0.1 && y < 0.85 && std::min(wave(6 * point.inner.x()), wave(2.6 * (y + 0.1))) > 0.25)
    finish = {{36, 38, 42}, 0.3};
  if (y < -0.25 && y > -0.8 && std::abs(point.inner.x()) < 0.25) finish.color *= 0.72;
}

void screen(const Look& look, const SurfacePoint& point, Finish& finish) {
  const bool upright = !point.moves && look.half.z() > 0.4 * look.half.y();
  const double x = point.inner.x(), y = upright ? point.inner.z() : point.moves ? -point.inner.y() : point.inner.y();
  if (look.folds_up && !point.moves) return keyboard(point, finish);
  if (!is_front(look, point)) {  // a lamp shows also from above
    if (look.on && point.normal.z() > 0.7 && Vec2(x, y).cwiseAbs().maxCoeff() < 0.45)
      finish = {{120, 210, 255}, 0, 0, true};
    if (look.on && std::abs(point.normal.x()) > 0.7 && std::abs(point.inner.z()) < 0.5)
      finish = {{120, 210, 255}, 0, 0, true};
    return;
  }
  constexpr double kFrame = 0.9;
  if (Vec2(x, y).cwiseAbs().maxCoeff() > kFrame) return;
  finish = look.on ? Finish{shown_picture(x / kFrame, y / kFrame), 0, 0, true} : Finish{{20, 22, 26}, 0.7};
}

/// Rings on the top, which glow when it is on; the front glows a little.
void burner(const Look& look, const SurfacePoint& point, Finish& finish) {
  if (point.normal.z() > 0.7) {
    const Vec2 four = look.half.minCoeff() > 0.18 ? Vec2((point.inner.head<2>().cwiseAbs() - Vec2::Constant(0.5)) * 2)
                                                  : Vec2(point.inner.head<2>());
    const double away = four.norm();
    if (away < 0.8 && wave(3 * away) > 0.45) {
      finish = look.on ? Finish{{255, 96, 30}, 0, 0, true} : Finish{{44, 42, 42}, 0.2};
    } else if (look.on && away < 1) {
      finish.color = mixed(finish.color, {150, 30, 14}, 0.6);
    }
    return;
  }
  if (look.on && wave(2.5 * point.inner.z()) > 0.6) finish = {{255, 110, 40}, 0, 0, true};
}

/// A window in the front behind which light burns, and a green lamp above.
void appliance(const Look& look, const SurfacePoint& point, Finish& finish) {
  const bool top = point.normal.z() > 0.7;
  if (!top && point.normal.y() > -0.4 && look.half.maxCoeff() > 0.3) return;
  const double x = top || std::abs(point.normal.y()) > 0.7 ? point.inner.x() : point.inner.y();
  const double y = top ? point.inner.y() : point.inner.z();
  if ((Vec2(x, y) - Vec2(0.74, 0.7)).squaredNorm() < 0.006) {
    finish = look.on ? Finish{{70, 255, 90}, 0, 0, true} : Finish{{70, 30, 30}, 0.2};
  } else if (std::abs(x) < 0.6 && std::abs(y) < 0.55) {
    finish = look.on ? Finish{mixed({255, 214, 130}, {255, 246, 214}, ramp(-0.6, 0.6, y)), 0, 0, true}
                     : Finish{mixed(finish.color, {34, 36, 42}, 0.7), 0.6};
  }
}

void power(const Look& look, const SurfacePoint& point, Finish& finish) {
  switch (look.device) {
    case Device::Lamp: {
      if (!look.on || point.inner.z() < -0.5) break;
      finish = {mixed({255, 238, 190}, {255, 252, 236}, std::abs(point.normal.z())), 0, 0, true};
      break;
    }
    case Device::Screen:
      screen(look, point, finish);
      break;
    case Device::Burner:
      burner(look, point, finish);
      break;
    case Device::Appliance:
      appliance(look, point, finish);
      break;
    case Device::Flame:
      if (look.on) finish.color = mixed(finish.color, {255, 186, 90}, 0.2 + 0.5 * ramp(-0.6, 1, point.inner.z()));
      break;
    case Device::Tap:
    case Device::None:
      break;
  }
}

}  // namespace

void show_states(const Look& look, const SurfacePoint& point, Finish& finish) {
  if (look.device != Device::None) power(look, point, finish);
  if (look.folded || look.unfolded) folds(look, point, finish);
  if (look.level > 0 && !look.pool) filled(look, point, finish);
  if (look.cut) cut(look, point, finish);
  if (look.used_up) used_up(look, point, finish);
  if (look.cooked && !look.burnt) cooked(look, point, finish);
  if (look.burnt) burnt(look, point, finish);
  if (look.cover.x() >= 0) covered(look, point, finish);
  if (look.dirty) dirty(look, point, finish);
  if (look.soaked) soaked(look, point, finish);
  if (look.hot) hot(point, finish);
  if (look.cool || look.frozen) cold(look, point, finish);
  if (look.broken) broken(look, point, finish);
}

}  // namespace unietp
