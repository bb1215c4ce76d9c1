#include "expert/situation.h"

#include <algorithm>

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

double Situation::walk_m(EntityIndex index) const {
  if (is_imagined(index)) return walk_m(slice(index).whole);
  std::optional<double>& known = walked_m_[index];
  if (!known) known = nodes[index] == nullptr ? 0.0 : std::min(world_.walking_distance(entity(index).id), kFar_m);
  return *known;
}

Situation look_around(const Rehearsal& rehearsal, Mode mode) {
  Situation situation(rehearsal.world());
  situation.start = &rehearsal.start();
  situation.knowledge = &rehearsal.knowledge();
  situation.profile = rehearsal.profile();
  for (const ActionInfo& action : all_actions()) {
    if (!offers(action, mode)) situation.profile.actions[static_cast<std::size_t>(action.type)] = false;
  }
  situation.trace.states.push_back(rehearsal.facts(rehearsal.world()));
  // The agent, the rooms and the nodes of the start; others were there in branches that were tried before.
  const std::size_t before_nodes = 1 + situation.start->rooms.size();
  const std::size_t count = before_nodes + situation.start->nodes.size();
  const auto& entities = rehearsal.entities();
  for (std::size_t e = 0; e < count; ++e) situation.trace.entities.push_back(entities[e]);
  situation.first_imagined = static_cast<EntityIndex>(count);
  situation.walked_m_.resize(count);
  situation.nodes.resize(count, nullptr);
  situation.shut_in.resize(count, kNobody);
  for (std::size_t i = before_nodes; i < count; ++i) {
    situation.nodes[i] = &situation.start->nodes[i - before_nodes];
    const std::string around = rehearsal.world().closed_around(entities[i].id);
    if (!around.empty()) situation.shut_in[i] = rehearsal.find(around).value_or(kNobody);
  }
  if (ranges_over_slices(rehearsal.goal())) imagine_slices(situation);
  return situation;
}

}  // namespace unietp
