#include "grounding/layout.h"

#include <algorithm>

#include "grounding/floor_plan.h"
#include "grounding/furnish.h"
#include "grounding/make_node.h"
#include "grounding/reachability.h"
#include "grounding/small_objects.h"
#include "simulation/relations.h"

namespace unietp {
namespace {

constexpr int kPlans = 60;            // floor plans tried
constexpr int kFurnishings = 80;      // furnishings tried
constexpr double kSizeSpread = 0.08;  // of furniture

/// The obligatory types once, then more of those that homes have several of.
std::vector<std::string> draw_rooms(const LayoutRecipe& recipe, int count, Rng rng) {
  std::vector<std::string> types;
  for (const std::string& type : recipe.rooms) {
    if (static_cast<int>(types.size()) < count) types.push_back(type);
  }
  std::vector<std::string> extra;
  for (const std::string& type : recipe.rooms) {
    if (type != "kitchen" && type != "living_room") extra.push_back(type);
  }
  if (extra.empty()) extra = recipe.rooms;
  while (static_cast<int>(types.size()) < count) types.push_back(rng.pick(extra));
  rng.shuffle(types);
  return types;
}

std::optional<Scene> draw_empty_home(const LayoutRecipe& recipe, Simulator simulator, int rooms, const std::string& id,
                                     const Rng& rng) {
  for (std::uint64_t i = 0; i < kPlans; ++i) {
    const Rng plan_rng = rng.fork("plan", i);
    auto plan = draw_floor_plan(draw_rooms(recipe, rooms, plan_rng.fork("rooms", 0)), plan_rng);
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

/// Furnishes every room; the name of an obligatory piece that found no place, or "".
std::string furnish(Workspace& workspace, const LayoutRecipe& recipe, const Knowledge& knowledge, const Rng& rng) {
  const FurnishOptions options;
  auto keep_outs = keep_outs_of(workspace, options);
  std::uint64_t piece = 0;
  for (const bool obligatory : {true, false}) {
    for (std::size_t room = 0; room < workspace.scene().rooms.size(); ++room) {
      const std::string type = workspace.scene().rooms[room].type;
      for (const FurnitureRule& rule : recipe.furniture) {
        if (rule.room != type) continue;
        Rng draw = rng.fork("piece", piece++);
        const auto spare = static_cast<std::uint64_t>(rule.at_most - rule.at_least + 1);
        const int count = obligatory ? rule.at_least : static_cast<int>(draw.below(spare));
        for (int k = 0; k < count; ++k) {
          Node node = make_node(workspace.scene(), knowledge, *knowledge.find(rule.category), kSizeSpread, draw);
          draw_states(node, knowledge, draw);
          const bool placed = place_furniture(workspace, keep_outs, room, std::move(node), *parse_where(rule.where),
                                              options, draw.fork("pose", static_cast<std::uint64_t>(k)));
          if (!placed && obligatory)
            return rule.category + " (" + rule.where + ") in " + workspace.scene().rooms[room].id;
          if (!placed) break;
        }
      }
    }
  }
  return "";
}

}  // namespace

Result<Scene> generate_layout(const LayoutRecipe& recipe, const Knowledge& knowledge, const Profile& profile,
                              const LayoutOptions& options, std::string id, Rng rng) {
  std::string obstacle = "no floor plan fits the rooms asked for";
  for (std::uint64_t attempt = 0; attempt < kFurnishings; ++attempt) {
    const Rng draw = rng.fork("attempt", attempt);
    auto empty = draw_empty_home(recipe, knowledge.simulator(), std::max(options.rooms, 5), id, draw);
    if (!empty) continue;
    Workspace workspace(std::move(*empty), knowledge);
    if (const std::string missing = furnish(workspace, recipe, knowledge, draw); !missing.empty()) {
      obstacle = "no place for " + missing;
      continue;
    }
    Scene furnished = workspace.scene();
    if (!stand_in_first_room(furnished, profile)) {
      obstacle = "no room to stand in " + furnished.rooms.front().id;
      continue;
    }
    if (const auto room = unreached_room(furnished, profile)) {
      obstacle = *room + " cannot be walked to";
      continue;
    }
    if (const auto piece = unreached_furniture(furnished, workspace.physics(), profile)) {
      obstacle = *piece + " is out of reach";
      continue;
    }
    workspace.agent() = furnished.agent;
    const auto furniture = static_cast<int>(workspace.scene().nodes.size());
    const int movable = options.objects > 0 ? std::max(0, options.objects - furniture) : options.movable_objects;
    scatter_objects(workspace, movable, options.attempts_per_object, draw.fork("objects", 0));
    workspace.read_edges();
    return std::move(workspace).take();
  }
  return Error{
      Error::Kind::Unsatisfiable,
      std::move(id),
      {},
      "no layout found in " + std::to_string(kFurnishings) + " attempts; the last failed because: " + obstacle};
}

}  // namespace unietp
