#include <algorithm>
#include <string_view>

#include "simulation/finish.h"
#include "simulation/noise.h"

namespace unietp {

bool is_window(const Node& node) {
  if (node.archetype != Archetype::Panel) return false;
  return node.category.find("indow") != std::string::npos && node.category.find("sill") == std::string::npos;
}

Look look_of(const Node& node, const ShapeFamily* family) {
  Look look;
  const StateSet& states = node.states;
  look.base = paint_of(node, family);
  look.matter = matter_of(node, family);
  if (states.has(Predicate::PowerOn) || states.has(Predicate::PowerOff))
    look.device = device_of(built_in_devices(), node.category);
  look.seed = number_of(node.id);
  look.half = node.size / 2;
  constexpr double kStains = 4, kLeast_m = 0.06, kMost_m = 0.9;  // stains across an object
  look.grain = kStains / std::clamp(node.size.maxCoeff(), kLeast_m, kMost_m);
  look.on = states.has(Predicate::PowerOn);
  look.dirty = states.has(Predicate::Dirty);
  look.soaked = states.has(Predicate::Soaked);
  look.hot = states.has(Predicate::Hot);
  look.cool = states.has(Predicate::Cool);
  look.cooked = states.has(Predicate::Cooked);
  look.burnt = states.has(Predicate::Burnt);
  look.frozen = states.has(Predicate::Frozen);
  look.cut = states.has(Predicate::Sliced) || !node.slice_of.empty();
  look.used_up = states.has(Predicate::UsedUp);
  look.broken = states.has(Predicate::Broken);
  look.folded = states.has(Predicate::Folded);
  look.unfolded = states.has(Predicate::Unfolded);
  look.folds_up = node.archetype == Archetype::Folding;
  look.window = is_window(node);
  for (const State& state : states.all()) {
    if (state.predicate == Predicate::Covered) look.cover = substance_paint(state.symbol);
    if (state.predicate != Predicate::Filled) continue;
    constexpr double kFull = 0.9;
    look.level = kFull;
    look.filling = substance_paint(state.symbol);
  }
  return look;
}

Color shown_filling(const Look& look) {
  constexpr double kNear = 85, kInside = 0.55;  // a hollow is darker than the body
  const auto apart = [&](const Color& color) {
    return std::min((color - look.base).cwiseAbs().maxCoeff(), (color - kInside * look.base).cwiseAbs().maxCoeff());
  };
  Color best = look.filling;
  for (const Color& other : {Color(look.filling * 0.6), mixed(look.filling, {244, 232, 214}, 0.5)}) {
    if (apart(best) < kNear && apart(other) > apart(best)) best = other;
  }
  return best;
}

}  // namespace unietp
