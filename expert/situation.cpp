#include "expert/situation.h"

#include <algorithm>

#include "scene/trace.h"

namespace unietp {
namespace {

bool ranges_over_slices(const Formula& formula) {
  for (const auto& member : formula.domain.members) {
    if (member.slice) return true;
  }
  return std::any_of(formula.children.begin(), formula.children.end(), ranges_over_slices);
}

/// The first rule by which something in the scene cuts the category; nullptr when nothing does.
const Effect* slicing_of(const Node& node, const Scene& scene, const Knowledge& knowledge) {
  for (const Effect* effect : knowledge.effects_on(node.category, "slices")) {
    for (const Node& tool : scene.nodes) {
      if (tool.category == effect->tool) return effect;
    }
  }
  return nullptr;
}

void imagine_slices(Situation& situation) {
  Facts later = situation.facts();
  const std::size_t real = situation.trace.entities.size();
  for (EntityIndex whole = 0; whole < real; ++whole) {
    const Node* node = situation.nodes[whole];
    if (node == nullptr || node->states.has(Predicate::Sliced)) continue;
    const Effect* effect = slicing_of(*node, *situation.start, *situation.knowledge);
    if (effect == nullptr) continue;
    // The first piece keeps the whole's identity, so that a goal can still speak of it; the others are new.
    for (int ordinal = 0; ordinal < std::max(2, effect->amount) - 1; ++ordinal) {
      const auto slice = static_cast<EntityIndex>(situation.trace.entities.size());
      situation.trace.entities.push_back(Entity{
          Entity::Kind::Object, node->id + "/slice_" + std::to_string(ordinal + 1), effect->gives, node->category});
      situation.imagined.push_back({whole, ordinal});
      situation.nodes.push_back(node);
      situation.walk_m.push_back(situation.walk_m[whole]);
      situation.shut_in.push_back(situation.shut_in[whole]);
      later.set_exists(slice);
      later.set(Predicate::SliceOf, slice, whole);
    }
  }
  situation.trace.states.push_back(std::move(later));
}

}  // namespace

bool has_operator(const Formula& formula, std::initializer_list<Formula::Op> operators) {
  return std::find(operators.begin(), operators.end(), formula.op) != operators.end() ||
         std::any_of(formula.children.begin(), formula.children.end(),
                     [operators](const Formula& part) { return has_operator(part, operators); });
}

Situation look_around(const World& world, const Scene& start, const Formula& goal, const Knowledge& knowledge,
                      const Profile& profile) {
  Situation situation;
  situation.start = &start;
  situation.knowledge = &knowledge;
  situation.profile = &profile;
  situation.trace = to_logic(start, {}, reads_comparisons(goal));
  situation.first_imagined = static_cast<EntityIndex>(situation.trace.entities.size());
  for (const Entity& entity : situation.trace.entities) {
    const Node* node = find_node(start, entity.id);
    situation.nodes.push_back(node);
    const double walk = node == nullptr ? 0.0 : world.walking_distance(entity.id);
    situation.walk_m.push_back(std::min(walk, Situation::kFar_m));
    const std::string around = node == nullptr ? std::string() : world.closed_around(entity.id);
    EntityIndex container = kNobody;
    for (EntityIndex other = 0; !around.empty() && other < situation.first_imagined; ++other) {
      if (situation.trace.entities[other].id == around) container = other;
    }
    situation.shut_in.push_back(container);
  }
  if (ranges_over_slices(goal)) imagine_slices(situation);
  return situation;
}

}  // namespace unietp
