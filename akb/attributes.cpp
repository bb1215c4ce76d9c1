#include "akb/attributes.h"

#include <algorithm>
#include <array>
#include <utility>

#include "akb/fit.h"
#include "scene/size_and_nearness.h"
#include "scene/trace.h"

namespace unietp {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 14> kAlike = {{
    {"brown", "gold"},
    {"brown", "orange"},
    {"gold", "orange"},
    {"gold", "yellow"},
    {"orange", "red"},
    {"orange", "yellow"},
    {"blue", "purple"},
    {"cardboard", "paper"},
    {"ceramic", "plastic"},
    {"ceramic", "stone"},
    {"fabric", "foam"},
    {"plastic", "rubber"},
    {"plastic", "wax"},
    {"wicker", "wood"},
}};

}  // namespace

bool distinguishable(std::string_view one, std::string_view other) {
  return one != other && std::none_of(kAlike.begin(), kAlike.end(), [&](const auto& pair) {
           return (pair.first == one && pair.second == other) || (pair.first == other && pair.second == one);
         });
}

bool comes_in_sizes(const Category& category, const Knowledge& knowledge) {
  if (has_trait(category, KindTrait::OneSize)) return false;
  double least = 0, most = 0;
  for (const Asset* asset : knowledge.assets_of(category.name)) {
    if (!usable(*asset, category)) continue;
    const double volume = asset->size.prod();
    least = least == 0 ? volume : std::min(least, volume);
    most = std::max(most, volume);
  }
  return least == 0 || most >= kClearlyLarger * least;
}

}  // namespace unietp
