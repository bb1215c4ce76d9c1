#include "grounding/layout.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

#include "grounding/floor_plan.h"
#include "grounding/floor_things.h"
#include "grounding/furnish.h"
#include "grounding/furniture_position.h"
#include "grounding/make_node.h"
#include "grounding/reach.h"
#include "grounding/reachability.h"
#include "grounding/room_doors.h"
#include "grounding/small_objects.h"

namespace unietp {
namespace {

constexpr int kPlans = 400;           // floor plans tried
constexpr int kFurnishings = 80;      // furnishings tried
constexpr double kSizeSpread = 0.08;  // of furniture
constexpr std::size_t kFewestRooms = 4;
constexpr int kFewestSeats = 2;          // at a table
constexpr std::uint64_t kExchanges = 7;  // times that what nobody gets at is exchanged; in the last it is left out
constexpr double kLeastSpare = 0.4;      // of the furniture that need not stand, however few objects are asked for

/// How many rooms of each type a home has so far.
class RoomCounts {
 public:
  explicit RoomCounts(const LayoutRecipe& recipe) : recipe_(recipe), counts_(recipe.rooms.size(), 0) {}

  int of(std::string_view type) const {
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      if (recipe_.rooms[i].type == type) return counts_[i];
    }
    return 0;
  }
  int of(std::size_t rule) const { return counts_[rule]; }
  void add(std::size_t rule) { ++counts_[rule]; }
  /// Whether there are as many bathrooms as suit the bedrooms with one room more.
  bool may_add(std::size_t rule) const {
    const std::string& type = recipe_.rooms[rule].type;
    return bathrooms_suit(of("bathroom") + (type == "bathroom" ? 1 : 0), of("bedroom") + (type == "bedroom" ? 1 : 0));
  }

 private:
  const LayoutRecipe& recipe_;
  std::vector<int> counts_;
};

/// Each type as often as it must be, and a corridor where there are more than four rooms; then those that are the
/// farthest below their share, drawn, within what a home has at most while that leaves any. A corridor comes first,
/// else a living room, then the others in random order.
std::vector<RoomRequest> draw_rooms(const LayoutRecipe& recipe, std::size_t count, Rng rng) {
  std::vector<std::size_t> chosen;
  RoomCounts have(recipe);
  double total = 0;
  const auto add = [&](std::size_t rule) {
    chosen.push_back(rule);
    have.add(rule);
  };
  for (std::size_t i = 0; i < recipe.rooms.size(); ++i) {
    const bool needed = count > kFewestRooms && recipe.rooms[i].type == "corridor";
    total += recipe.rooms[i].weight;
    for (int k = 0; k < std::max(recipe.rooms[i].at_least, needed ? 1 : 0) && chosen.size() < count; ++k) add(i);
  }
  while (chosen.size() < count) {
    std::vector<double> lacking;
    for (std::size_t i = 0; i < recipe.rooms.size(); ++i) {
      const double share = recipe.rooms[i].weight / total * static_cast<double>(count);
      const bool corridor = recipe.rooms[i].type == "corridor", enough = have.of(i) >= recipe.rooms[i].at_most;
      const double wanted = enough ? 1e-6 : std::max(share - have.of(i), 0.05 * share);
      lacking.push_back(corridor || !have.may_add(i) ? 0 : wanted);
    }
    add(rng.weighted(lacking));
  }
  rng.shuffle(chosen);
  for (const char* entered : {"living_room", "corridor"}) {
    const auto found =
        std::find_if(chosen.begin(), chosen.end(), [&](std::size_t i) { return recipe.rooms[i].type == entered; });
    if (found != chosen.end()) std::iter_swap(chosen.begin(), found);
  }
  std::vector<RoomRequest> requests;
  for (const std::size_t i : chosen) {
    const RoomRule& rule = recipe.rooms[i];
    requests.push_back({rule.type, rng.uniform(rule.area_low_m2, rule.area_high_m2)});
  }
  return requests;
}

std::optional<Scene> draw_empty_home(const LayoutRecipe& recipe, Simulator simulator, int rooms, const std::string& id,
                                     const Rng& rng) {
  const std::size_t count = std::max(static_cast<std::size_t>(std::max(rooms, 0)), kFewestRooms);
  for (std::uint64_t i = 0; i < kPlans; ++i) {
    const Rng plan_rng = rng.fork("plan", i);
    auto plan = draw_floor_plan(draw_rooms(recipe, count, plan_rng.fork("rooms", 0)), recipe.doors, plan_rng);
    if (!plan) continue;
    Scene scene;
    scene.id = id;
    scene.simulator = simulator;
    scene.rooms = std::move(plan->rooms);
    scene.openings = std::move(plan->openings);
    return scene;
  }
  return std::nullopt;
}

/// How many more than obligatory: binomial, so that the mean is the rule's when all of the spare furniture is wanted.
int draw_more(const FurnitureRule& rule, double share, Rng& rng) {
  const int spare = rule.at_most - rule.at_least;
  int more = 0;
  for (int k = 0; k < spare; ++k) more += rng.chance(share * (rule.mean - rule.at_least) / spare) ? 1 : 0;
  return more;
}

bool has_piece(const Workspace& workspace, std::size_t room, const std::string& category) {
  const auto& all = workspace.places().of(category);
  return std::any_of(all.begin(), all.end(),
                     [&](std::size_t i) { return workspace.room_of(i) == &workspace.scene().rooms[room]; });
}

/// The same of what goes with a host that need not stand: as many as go with one, so that the mean is the rule's again.
/// A desk that takes one seat has it, and a table that takes several has two at least.
int draw_companions(const FurnitureRule& rule, const FurniturePosition& where, double hosts, Rng& rng) {
  const double mean = std::min(static_cast<double>(rule.at_most), rule.mean / std::min(1.0, hosts));
  const int count = static_cast<int>(mean) + (rng.chance(mean - std::floor(mean)) ? 1 : 0);
  const int seats = where.kind == FurniturePosition::Kind::At ? std::min(rule.at_most, kFewestSeats) : 0;
  return std::max(count, seats) - rule.at_least;
}

/// Real homes hold more than is asked for here: the share of what need not stand that leaves the small things theirs.
double spare_share(const LayoutRecipe& recipe, const Scene& empty, const LayoutOptions& options) {
  const double still = 1 - recipe.movable_share;
  const double wanted = options.objects > 0 ? still * options.objects
                                            : still * options.movable_objects / std::max(0.1, recipe.movable_share);
  double obligatory = 0, spare = 0;
  for (const Room& room : empty.rooms) {
    for (const FurnitureRule& rule : recipe.furniture) {
      if (rule.room != room.type) continue;
      obligatory += rule.at_least;
      spare += rule.mean - rule.at_least;
    }
  }
  return spare > 0 ? std::clamp((wanted - obligatory) / spare, kLeastSpare, 1.0) : 1.0;
}

/// The mean number of such a piece in a room of the type; 0 when one must stand there.
double mean_of_spare(const LayoutRecipe& recipe, const std::string& room, const std::string& category) {
  double mean = 0;
  for (const FurnitureRule& rule : recipe.furniture) {
    if (rule.room != room || rule.category != category) continue;
    if (rule.at_least > 0) return 0;
    mean += rule.mean;
  }
  return mean;
}

struct Furnished {
  std::string missing;               // an obligatory piece that found no place, or ""
  std::set<std::string> obligatory;  // ids of the pieces that the recipe demands
};

/// Furnishes every room, first with what it must have.
Furnished furnish(Workspace& workspace, const LayoutRecipe& recipe, const Knowledge& knowledge, double spare,
                  const Rng& rng) {
  Furnished result;
  const FurnishOptions options;
  auto keep_outs = keep_outs_at_openings(workspace.scene());
  keep_outs.push_back(keep_out_at_entrance(workspace.scene()));
  std::uint64_t piece = 0;
  for (const bool obligatory : {true, false}) {
    for (std::size_t room = 0; room < workspace.scene().rooms.size(); ++room) {
      const std::string type = workspace.scene().rooms[room].type;
      for (const FurnitureRule& rule : recipe.furniture) {
        if (rule.room != type) continue;
        Rng draw = rng.fork("piece", piece++);
        const FurniturePosition where = *parse_furniture_position(rule.where);
        if (!obligatory && !where.host.empty() && !has_piece(workspace, room, where.host)) continue;
        const double hosts = where.host.empty() ? 0 : mean_of_spare(recipe, type, where.host);
        const bool goes_along = hosts > 0 || where.kind == FurniturePosition::Kind::At;
        const int count = obligatory   ? rule.at_least
                          : goes_along ? draw_companions(rule, where, hosts > 0 ? hosts : 1, draw)
                                       : draw_more(rule, spare, draw);
        for (int k = 0; k < count; ++k) {
          Node node = make_node(workspace, *knowledge.find(rule.category), kSizeSpread, draw);
          draw_states(node, workspace, {}, draw);
          if (obligatory) result.obligatory.insert(node.id);
          const bool placed = place_furniture(workspace, keep_outs, room, std::move(node), where, options,
                                              draw.fork("pose", static_cast<std::uint64_t>(k)));
          if (!placed && obligatory) {
            result.missing = rule.category + " (" + rule.where + ") in " + workspace.scene().rooms[room].id;
            return result;
          }
          if (!placed) break;
        }
      }
    }
  }
  return result;
}

/// Takes away what nobody can reach and no rule demands; the id of a piece that is demanded, or "".
std::string drop_unreached(Scene& furnished, const Workspace& workspace, const Profile& profile, const Walk& walk,
                           const std::set<std::string>& obligatory) {
  std::set<std::string_view> dropped;
  for (const std::size_t i : unreached_furniture(furnished, workspace.physics(), profile, walk)) {
    if (obligatory.contains(furnished.nodes[i].id)) return furnished.nodes[i].id;
    dropped.insert(workspace.scene().nodes[i].id);
  }
  erase_if(furnished.nodes, [&](const Node& node) { return dropped.contains(node.id); });
  return "";
}

/// Takes away what rests on or in a node, and then the node. The edges are as before.
void remove_with_load(Workspace& workspace, const std::vector<std::string>& ids) {
  std::set<std::string> gone(ids.begin(), ids.end());
  for (bool more = true; more;) {
    more = false;
    for (const Edge& edge : workspace.scene().edges) {
      const bool rests = edge.relation == Predicate::On || edge.relation == Predicate::Inside;
      if (rests && gone.contains(edge.to)) more = gone.insert(edge.from).second || more;
    }
  }
  for (const std::string& id : gone) {
    if (const auto index = workspace.places().find(id)) workspace.remove(*index);
  }
}

/// Ids of the small things that the agent cannot get at, behind doors that it opens too.
std::vector<std::string> unreached_things(const Workspace& workspace, const Walk& walk, const Profile& profile) {
  const Scene& scene = workspace.scene();
  Reach reach(scene, workspace.places(), workspace.physics(), std::make_shared<const Walk>(walk), profile);
  std::vector<std::string> unreached;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (scene.nodes[i].movable && !reach.object(i)) unreached.push_back(scene.nodes[i].id);
  }
  return unreached;
}

}  // namespace

Result<Scene> generate_layout(const LayoutRecipe& recipe, const Knowledge& knowledge, const Profile& profile,
                              const LayoutOptions& options, std::string id, Rng rng) {
  std::string obstacle = "no floor plan fits the rooms asked for";
  for (std::uint64_t attempt = 0; attempt < kFurnishings; ++attempt) {
    const Rng draw = rng.fork("attempt", attempt);
    auto empty = draw_empty_home(recipe, knowledge.simulator(), options.rooms, id, draw);
    if (!empty) continue;
    const double spare = spare_share(recipe, *empty, options);
    Workspace workspace(std::move(*empty), knowledge);
    workspace.set_household(recipe.household.get());
    const Furnished furnished = furnish(workspace, recipe, knowledge, spare, draw);
    if (!furnished.missing.empty()) {
      obstacle = "no place for " + furnished.missing;
      continue;
    }
    Scene scene = workspace.scene();
    NavigationGrid grid(scene, profile);
    if (!stand_at_entrance(scene, grid)) {
      obstacle = "no room to stand at the entrance in " + scene.rooms.front().id;
      continue;
    }
    CellSet reached = grid.reached_from(grid.cell_at(scene.agent.position));
    const Walk walk{std::move(grid), std::move(reached), {}};
    if (const auto room = unreached_room(scene, walk)) {
      obstacle = *room + " cannot be walked to";
      continue;
    }
    if (const std::string piece = drop_unreached(scene, workspace, profile, walk, furnished.obligatory);
        !piece.empty()) {
      obstacle = piece + " is out of reach";
      continue;
    }
    if (scene.nodes.size() < workspace.scene().nodes.size()) {
      workspace = Workspace(std::move(scene), knowledge);
      workspace.set_household(recipe.household.get());
    } else {
      workspace.agent() = scene.agent;
    }
    ScatterOptions scatter;
    const auto pieces = static_cast<int>(workspace.scene().nodes.size());
    scatter.wanted = options.objects > 0 ? std::max(0, options.objects - pieces) : options.movable_objects;
    scatter.draws_per_object = options.attempts_per_object;
    scatter.settle = options.settle;
    const auto low = static_cast<int>(std::lround(scatter.wanted * recipe.floor_share));
    scatter.wanted -= put_on_floors(workspace, recipe, walk, low, options.settle, draw.fork("floors", 0));
    scatter_objects(workspace, recipe, scatter, draw.fork("objects", 0));
    workspace.read_edges();
    Walk between = walk_in(workspace.scene(), profile);
    const std::size_t wanted = workspace.scene().nodes.size();
    for (std::uint64_t round = 1; round <= kExchanges; ++round) {
      const auto unreached = unreached_things(workspace, between, profile);
      if (unreached.empty() && workspace.scene().nodes.size() == wanted) break;
      remove_with_load(workspace, unreached);
      scatter.wanted = static_cast<int>(wanted - workspace.scene().nodes.size());
      if (round < kExchanges) scatter_objects(workspace, recipe, scatter, draw.fork("objects", round));
      workspace.read_edges();
      between = walk_in(workspace.scene(), profile);
    }
    if (const auto room = unreached_room(workspace.scene(), between)) {
      obstacle = *room + " cannot be walked to between the things on the floor";
      continue;
    }
    if (const auto behind = unreached_furniture(workspace.scene(), workspace.physics(), profile, between);
        !behind.empty()) {
      obstacle = workspace.scene().nodes[behind.front()].id + " is out of reach behind small things";
      continue;
    }
    return std::move(workspace).take();
  }
  return Error{
      Error::Kind::Unsatisfiable,
      std::move(id),
      {},
      "no layout found in " + std::to_string(kFurnishings) + " attempts; the last failed because: " + obstacle};
}

}  // namespace unietp
