#include "grounding/make_node.h"

#include <algorithm>

#include "akb/default_states.h"
#include "akb/fit.h"
#include "scene/fresh_id.h"

namespace unietp {
namespace {

constexpr double kDirtyShare = 0.15;
constexpr double kLightOnShare = 0.3;
constexpr double kFullShare = 0.1;
constexpr double kFoldedOpenShare = 0.25;

}  // namespace

Node make_node(const Workspace& workspace, const Category& category, double spread, Rng& rng) {
  const Knowledge& knowledge = workspace.knowledge();
  Node node;
  node.id = drawn_id(workspace.scene(), workspace.places(), category.name,
                     workspace.home() == nullptr ? nullptr : &workspace.home()->places);
  node.category = category.name;
  node.movable = category.movable;
  node.archetype = category.archetype;
  node.openable = knowledge.has(category.name, "openable");
  Vec3 factor = Vec3::Constant(rng.uniform(1 - spread, 1 + spread));
  if (const auto assets = usable_assets(knowledge, category); !assets.empty()) {
    const Asset& asset = *rng.pick(assets);
    node.asset = asset.name;
    factor = asset.size.cwiseQuotient(category.size);
  } else if (!category.movable) {
    factor.y() = rng.uniform(1 - spread, 1 + spread);
    factor.z() = rng.uniform(1 - spread, 1 + spread);
  }
  node.size = node.asset.empty() ? category.size.cwiseProduct(factor) : knowledge.asset(node.asset)->size;
  node.mass = category.mass * factor.prod();
  if (!category.colors.empty()) node.color = rng.pick(category.colors);
  if (!category.materials.empty()) node.material = rng.pick(category.materials);
  set_default_states(node, knowledge);
  return node;
}

std::vector<const Asset*> usable_assets(const Knowledge& knowledge, const Category& category) {
  std::vector<const Asset*> models = knowledge.assets_of(category.name);
  std::erase_if(models, [&](const Asset* asset) { return !usable(*asset, category); });
  return models;
}

std::string draw_filling(std::string_view category, const Knowledge& knowledge, Rng& rng) {
  std::vector<std::string> substances;
  for (const Effect* effect : knowledge.effects_on(category, Treatment::Fills)) {
    if (!effect->gives.empty()) substances.push_back(effect->gives);
  }
  std::sort(substances.begin(), substances.end());
  substances.erase(std::unique(substances.begin(), substances.end()), substances.end());
  return substances.empty() ? std::string() : rng.pick(substances);
}

bool can_be(const Node& node, const Knowledge& knowledge, const State& state) {
  if (state.predicate == Predicate::Covered) return knowledge.has(node.category, "coverable");
  if (state.predicate == Predicate::Filled) {
    const auto fillings = knowledge.effects_on(node.category, Treatment::Fills);
    if (std::none_of(fillings.begin(), fillings.end(), [&](const Effect* one) { return one->gives == state.symbol; }))
      return false;
  }
  const auto& groups = state_groups();
  return std::any_of(groups.begin(), groups.end(), [&](const StateGroup& group) {
    const auto& all = group.predicates;
    return std::find(all.begin(), all.end(), state.predicate) != all.end() && node.states.has(all.front());
  });
}

void unfold_if_dirty(Node& node) {
  if (node.states.has(Predicate::Dirty) && node.states.has(Predicate::Folded))
    node.states.set({Predicate::Unfolded, {}});
}

namespace {

/// Whether it opens without that anything has to be kept free of its doors.
bool opens_in_place(const Node& node) {
  if (node.movable) return node.archetype == Archetype::Folding;
  Node open = node;
  open.opening = 1;
  return !sweep_of(open);
}

void draw_likely_states(Node& node, const Knowledge& knowledge, const Household& household,
                        const HostRelation& host_relation, Rng& rng) {
  for (const LikelyState& likely :
       household.states_of(node.category, host_relation.relation, host_relation.receptacle)) {
    if (!rng.chance(likely.share) || !can_be(node, knowledge, likely.state)) continue;
    if (likely.state.predicate == Predicate::Open) {
      if (!opens_in_place(node)) continue;
      node.opening = 1;
    }
    node.states.set(likely.state);
  }
  unfold_if_dirty(node);
}

}  // namespace

void draw_states(Node& node, const Workspace& workspace, const HostRelation& host_relation, Rng& rng) {
  const Knowledge& knowledge = workspace.knowledge();
  if (workspace.household() != nullptr)
    return draw_likely_states(node, knowledge, *workspace.household(), host_relation, rng);
  const Category* category = knowledge.find(node.category);
  if (node.states.has(Predicate::Clean) && rng.chance(kDirtyShare)) node.states.set({Predicate::Dirty, {}});
  if (node.states.has(Predicate::PowerOff) && category && has_trait(*category, KindTrait::GivesLight) &&
      rng.chance(kLightOnShare)) {
    node.states.set({Predicate::PowerOn, {}});
  }
  if (node.states.has(Predicate::Empty) && rng.chance(kFullShare)) {
    if (std::string substance = draw_filling(node.category, knowledge, rng); !substance.empty()) {
      node.states.set({Predicate::Filled, std::move(substance)});
    }
  }
  if (node.movable && node.archetype == Archetype::Folding && node.states.has(Predicate::Closed) &&
      rng.chance(kFoldedOpenShare)) {
    node.states.set({Predicate::Open, {}});
    node.opening = 1;
  }
}

}  // namespace unietp
