#include "grounding/crowding.h"

#include <algorithm>
#include <array>

namespace unietp {
namespace {

constexpr std::size_t kMostOfOne = 2;  // of a category of which homes do not have several
constexpr int kMostAtOne = 4;          // things that come to one place: a table is not a shop
constexpr int kMostAlikeAt = 3;        // of a category of which homes have several, at one place

}  // namespace

bool may_be_so_many(const Workspace& workspace, std::size_t number, std::size_t more, const std::string& category) {
  const auto* household = workspace.household();
  return household == nullptr || household->has_several(category) || number + more <= kMostOfOne;
}

bool is_enough(const Workspace& workspace, const std::string& category, int changed) {
  const auto* household = workspace.household();
  const auto most = static_cast<int>(kMostOfOne);
  return household != nullptr && changed >= (household->has_several(category) ? 2 * most : most);
}

bool has_room_for(const Workspace& workspace, const std::string& category, const Node& host, int together) {
  const auto* household = workspace.household();
  if (household == nullptr) return true;
  const auto carried = workspace.carried_by(*workspace.places().find(host.id));
  const auto thing = [&](const std::string& id) -> const Node& {
    return workspace.scene().nodes[*workspace.places().find(id)];
  };
  const auto is_other = [&](const std::string& id) { return thing(id).category != category; };
  const Category* kept_in = workspace.knowledge().find(host.category);
  const bool dish = kept_in != nullptr && has_trait(*kept_in, KindTrait::Dish);
  if (dish && std::any_of(carried.begin(), carried.end(), is_other)) return false;
  const Home& home = *workspace.home();
  int came = 0, alike = 0;
  for (const std::string& id : carried) {
    const Node& node = thing(id);
    const auto before = home.places.find(id);
    if (!before || home.scene.nodes[*before].pose.position != node.pose.position) ++came;
    if (node.category == category) ++alike;
  }
  return came < std::max(kMostAtOne, together) &&
         alike < (household->has_several(category) ? std::max(kMostAlikeAt, together) : 1);
}

bool may_be_common(const State& state) {
  using enum Predicate;
  constexpr std::array kNever{Hot, Cool, RoomTemperature, Frozen, Thawed, PowerOn, Broken, Sliced, Burnt};
  return std::find(kNever.begin(), kNever.end(), state.predicate) == kNever.end();
}

}  // namespace unietp
