#include "grounding/floor_things.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include "grounding/furnish.h"
#include "grounding/make_node.h"
#include "grounding/place_object.h"

namespace unietp {
namespace {

constexpr double kFloorSizeSpread = 0.04;
constexpr int kSpotsTried = 12;          // for one thing
constexpr double kFromTheWall_m = 0.07;  // of the space for it: half a wall and a hair
constexpr double kPlay_m = 0.12;         // that the space is larger than the thing, each way
constexpr double kBeforeIt_m = 0.6;      // kept free, so that somebody can stand there
constexpr double kWithoutRule = 0.2;     // number in a room of what no real home has there
constexpr double kAlike = 0.25;          // chance of another one of a category in the same room

/// Categories with how often each is on the floor of a room.
class FloorChoice {
 public:
  FloorChoice(const Workspace& workspace, const LayoutRecipe& recipe) : workspace_(workspace), recipe_(recipe) {
    for (const Category& category : workspace.knowledge().categories()) {
      if (category.movable && workspace.household()->on_floor(category.name) > 0) categories_.push_back(&category);
    }
  }
  bool empty() const { return categories_.empty(); }

  /// nullptr when the room's type has none.
  const Category* draw(std::size_t room, Rng& rng) {
    const std::string& type = workspace_.scene().rooms[room].type;
    std::vector<double> weights;
    double sum = 0;
    for (const Category* category : categories_) {
      const double suits = workspace_.household()->in_room(category->name, type);
      const double again = std::pow(kAlike, there_[{room, category->name}]);
      const bool here = suits >= Household::kNoRoom;
      weights.push_back(
          here ? suits * again * workspace_.household()->on_floor(category->name) * mean_in(type, *category) : 0);
      sum += weights.back();
    }
    if (sum <= 0) return nullptr;
    const Category* drawn = categories_[rng.weighted(weights)];
    ++there_[{room, drawn->name}];
    return drawn;
  }

 private:
  double mean_in(const std::string& type, const Category& category) const {
    for (const ObjectRule& rule : recipe_.objects) {
      if (rule.room == type && rule.category == category.name) return rule.mean;
    }
    return kWithoutRule;
  }

  const Workspace& workspace_;
  const LayoutRecipe& recipe_;
  std::vector<const Category*> categories_;
  std::map<std::pair<std::size_t, std::string_view>, int> there_;
};

/// A space along a wall of a room for a thing that lies along it, and the space before it.
struct Spot {
  Bounds space, before;
};
Spot draw_spot(const Bounds& room, const Vec3& size, Rng& rng) {
  const double width = size.head<2>().maxCoeff() + kPlay_m, depth = size.head<2>().minCoeff() + kPlay_m;
  const int across = static_cast<int>(rng.below(2)), along = 1 - across;
  const bool low_side = rng.chance(0.5);
  const double slack = room.high[along] - room.low[along] - width - 2 * kFromTheWall_m;
  const double from = room.low[along] + kFromTheWall_m + rng.unit() * std::max(0.0, slack);
  Spot spot;
  spot.space.low[along] = spot.before.low[along] = from;
  spot.space.high[along] = spot.before.high[along] = from + width;
  const double inner = low_side ? room.low[across] + kFromTheWall_m : room.high[across] - kFromTheWall_m;
  const double far = low_side ? inner + depth : inner - depth,
               beyond = low_side ? far + kBeforeIt_m : far - kBeforeIt_m;
  spot.space.low[across] = std::min(inner, far);
  spot.space.high[across] = std::max(inner, far);
  spot.before.low[across] = std::min(far, beyond);
  spot.before.high[across] = std::max(far, beyond);
  spot.space.low.z() = spot.before.low.z() = 0.01;
  spot.space.high.z() = size.z() + 0.01;
  spot.before.high.z() = 1.8;
  return spot;
}

bool is_taken(const Workspace& workspace, const Bounds& space) {
  const auto near = workspace.physics().near(space, 0);
  return std::any_of(near.begin(), near.end(),
                     [&](BodyId body) { return body.is_node() && overlap(workspace.bounds()[body.index()], space); });
}

}  // namespace

int put_on_floors(Workspace& workspace, const LayoutRecipe& recipe, const Walk& walk, int wanted, bool settle,
                  Rng rng) {
  if (workspace.household() == nullptr) return 0;
  FloorChoice choice(workspace, recipe);
  if (choice.empty()) return 0;
  const Scene& scene = workspace.scene();
  std::vector<double> areas;
  std::vector<Bounds> rooms;
  std::vector<std::vector<KeepOut>> keep_outs;
  for (std::size_t room = 0; room < scene.rooms.size(); ++room) {
    rooms.push_back(room_bounds(scene.rooms[room], scene.wall_height));
    areas.push_back((rooms.back().high - rooms.back().low).head<2>().prod());
    keep_outs.push_back(keep_outs_of(workspace, {}, room));
  }
  keep_outs.front().push_back(keep_out_at_entrance(scene));
  int placed = 0;
  for (std::uint64_t thing = 0; thing < 2 * static_cast<std::uint64_t>(std::max(0, wanted)) && placed < wanted;
       ++thing) {
    Rng draw = rng.fork("thing", thing);
    const std::size_t room = draw.weighted(areas);
    const Category* category = choice.draw(room, draw);
    if (category == nullptr) continue;
    Node node = make_node(workspace, *category, kFloorSizeSpread, draw);
    draw_states(node, workspace, {}, draw);
    for (int tried = 0; tried < kSpotsTried; ++tried) {
      const Spot spot = draw_spot(rooms[room], node.size, draw);
      const bool kept_out = std::any_of(keep_outs[room].begin(), keep_outs[room].end(),
                                        [&](const KeepOut& one) { return overlap(one.space, spot.space); });
      if (kept_out || is_taken(workspace, spot.space) || is_taken(workspace, spot.before)) continue;
      const auto cell = walk.grid.cell_at((spot.before.low + spot.before.high).head<2>() / 2);
      if (!walk.reached.has(cell.x, cell.y)) continue;
      PlacementOptions options;
      options.draws = 2;
      options.settle = settle;
      const FoundPlace place = find_place_on_floor(workspace, node, scene.nodes.size(), spot.space, options,
                                                   draw.fork("pose", static_cast<std::uint64_t>(tried)));
      if (!place.pose) continue;
      node.pose = *place.pose;
      workspace.add(std::move(node));
      ++placed;
      break;
    }
  }
  return placed;
}

}  // namespace unietp
