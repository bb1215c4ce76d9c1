#include "interchange/model_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
  const auto centimetres = [](double metres) { return number_text(std::round(metres * 1000) / 10); };
  return centimetres(size.x()) + " x " + centimetres(size.y()) + " x " + centimetres(size.z()) + " cm";
}

}  // namespace

const Asset* model_for(const Node& node, const Knowledge& knowledge, std::string& why) {
  if (const Asset* own = knowledge.asset(node.asset); own != nullptr && own->category == node.category) return own;
  const auto models = knowledge.assets_of(node.category);
  if (models.empty()) {
    why = "the simulator has no model of " + node.category;
    return nullptr;
  }
  const Asset* best = *std::min_element(models.begin(), models.end(), [&](const Asset* a, const Asset* b) {
    return misfit(a->size, node.size) < misfit(b->size, node.size);
  });
  if (misfit(best->size, node.size) <= 1) return best;
  why = "no model fits its box of " + box_text(node.size) + "; the nearest, " + best->name + ", has " +
        box_text(best->size);
  return nullptr;
}

}  // namespace unietp
