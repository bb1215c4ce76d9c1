#include "simulation/contrast.h"

#include <algorithm>
#include <cmath>

#include "simulation/channels.h"

namespace unietp {

Contrast contrast_of(const Node& one, const Node& other, Simulator simulator) {
  constexpr int kPixels = 64;
  Profile profile;
  profile.simulator = simulator;
  const PortraitOptions options{.pixels = kPixels, .on_table = one.movable};
  Rays rays;
  const Portrait first = portrait_scene(one, profile, options), second = portrait_scene(other, profile, options);
  const auto shows = [&](const Portrait& portrait) {
    return segmentation_of(portrait.scene, portrait.camera, rays).node;
  };
  const auto of_first = shows(first), of_second = shows(second);
  const Picture a = picture_of(first.scene, first.camera, rays), b = picture_of(second.scene, second.camera, rays);
  const auto thing = static_cast<std::int32_t>(first.scene.nodes.size()) - 1;  // in both
  Contrast contrast;
  std::size_t pixels = 0, clear = 0;
  for (std::size_t i = 0; i < of_first.size(); ++i) {
    if (of_first[i] != thing && of_second[i] != thing) continue;
    double apart = 0;
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) apart += std::abs(a.rgb[c] - b.rgb[c]) / 3.0;
    contrast.mean += apart;
    clear += apart >= kClearDifference ? 1 : 0;
    ++pixels;
  }
  if (pixels == 0) return {};
  contrast.mean /= static_cast<double>(pixels);
  contrast.clear = static_cast<double>(clear) / static_cast<double>(pixels);
  return contrast;
}

std::optional<Node> with_look_of(const Node& one, const Node& other, Predicate predicate) {
  Node changed = one;
  if (predicate == Predicate::Color) {
    changed.color = other.color;
  } else if (predicate == Predicate::Material) {
    changed.material = other.material;
  } else if (const auto group = info(predicate).group; !group.empty()) {
    for (const PredicateInfo& state : all_predicates()) {
      if (state.group == group) changed.states.clear(state.predicate);
    }
    for (const State& state : other.states.all()) {
      if (info(state.predicate).group == group) changed.states.set(state);
    }
    if (predicate == Predicate::Open || predicate == Predicate::Closed) changed.opening = other.opening;
  } else if (predicate == Predicate::Covered) {
    changed.states.clear(predicate);
    for (const State& state : other.states.all()) {
      if (state.predicate == predicate) changed.states.set(state);
    }
  } else {
    return std::nullopt;
  }
  if (changed == one) return std::nullopt;
  return changed;
}

}  // namespace unietp
