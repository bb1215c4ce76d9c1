#include "interchange/model_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/text.h"

namespace unietp {
namespace {

constexpr double kLargestShare = 1.0 / 3, kSmall_m = 0.05;

/// The largest difference of the extents as a share of what is allowed.
double misfit(const Vec3& model, const Vec3& size) {
  double worst = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double allowed = std::max(kLargestShare * size[axis], kSmall_m);
    worst = std::max(worst, std::abs(model[axis] - size[axis]) / allowed);
  }
  return worst;
}

std::string box_text(const Vec3& size) {
  const auto centimeters = [](double meters) { return number_text(std::round(meters * 1000) / 10); };
  return centimeters(size.x()) + " x " + centimeters(size.y()) + " x " + centimeters(size.z()) + " cm";
}

/// The size of a model's box in the node's frame.
Vec3 turned(const Vec3& size, const Quat& turn) { return turn.toRotationMatrix().cwiseAbs() * size; }

/// Upright, and the other five ways in which a box can fill an upright one.
std::vector<Quat> ways_to_lie(const Node& node) {
  std::vector<Quat> ways{Quat::Identity()};
  if (!node.movable || node.archetype != Archetype::Box) return ways;
  const double h = std::sqrt(0.5);
  const Quat about_x(h, h, 0, 0), about_y(h, 0, h, 0), about_z(h, 0, 0, h);
  for (const Quat& way : {about_z, about_y, about_x, Quat(about_z * about_x), Quat(about_x * about_z)})
    ways.push_back(way);
  return ways;
}

/// The best of some models; none with a reason.
ChosenModel best_of(const std::vector<const Asset*>& models, const Node& node, std::string& why) {
  struct Fit {
    const Asset* model;
    Quat turn;
    double misfit;
  };
  std::vector<Fit> fits;  // the best of each way, upright first
  for (const Quat& turn : ways_to_lie(node)) {
    Fit best{nullptr, turn, std::numeric_limits<double>::infinity()};
    for (const Asset* const model : models) {
      const double worst = misfit(turned(model->size, turn), node.size);
      if (worst < best.misfit) best = {model, turn, worst};
    }
    fits.push_back(best);
  }
  if (fits.front().misfit <= 1) return {fits.front().model, fits.front().turn};
  const Fit& best =
      *std::min_element(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) { return a.misfit < b.misfit; });
  if (best.misfit <= 1) return {best.model, best.turn};
  const Asset* const nearest = fits.front().model;
  if (nearest == nullptr) return {};
  why = "no model fits its box of " + box_text(node.size) + "; the nearest, " + nearest->name + ", has " +
        box_text(nearest->size);
  return {};
}

}  // namespace

ChosenModel model_for(const Node& node, const Knowledge& knowledge, const FormatFacts& facts, std::string& why) {
  if (const Asset* own = knowledge.asset(node.asset); own != nullptr && own->category == node.category) return {own};
  const auto all = knowledge.asset_rows_of(node.category);
  if (all.empty()) {
    why = "no model of " + node.category + " is known";
    return {};
  }
  std::vector<const Asset*> models(all.begin(), all.end());
  std::erase_if(models, [&](const Asset* model) { return facts.model_lacks.contains(model->name); });
  if (ChosenModel able = best_of(models, node, why); able.asset != nullptr) return able;
  return best_of({all.begin(), all.end()}, node, why);
}

}  // namespace unietp
