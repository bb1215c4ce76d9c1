#include <algorithm>
#include <array>

#include "grounding/make_node.h"
#include "grounding/scene_editor.h"
#include "simulation/shape.h"

namespace unietp {
namespace {

const StateGroup* group_with(Predicate predicate) {
  for (const StateGroup& group : state_groups()) {
    if (std::find(group.predicates.begin(), group.predicates.end(), predicate) != group.predicates.end()) return &group;
  }
  return nullptr;
}

/// A value of the list that is (or is not) the given one; "" when there is none.
std::string choose(const std::vector<std::string>& values, const std::string& symbol, bool same) {
  for (const std::string& value : values) {
    if ((value == symbol || (same && symbol == "any")) == same) return value;
  }
  return "";
}

}  // namespace

bool SceneEditor::set_state(const std::string& id, Predicate predicate, const std::string& symbol, bool truth) {
  const auto index = index_of(id);
  if (!index) return fail(RejectionReason::CannotEnforce, id + " is not an object");
  Node node = workspace_.scene().nodes[*index];
  const Knowledge& knowledge = workspace_.knowledge();
  const Category* category = knowledge.find(node.category);
  const std::string state_text =
      std::string(truth ? "" : "not ") + std::string(info(predicate).name) + (symbol.empty() ? "" : " " + symbol);
  const auto impossible = [&] {
    return fail(RejectionReason::StateNotPossible, node.category + " cannot be " + state_text);
  };
  if (predicate == Predicate::Size) return resize(id, symbol, truth);
  if (predicate == Predicate::Color || predicate == Predicate::Material) {
    std::string& field = predicate == Predicate::Color ? node.color : node.material;
    const auto& values = predicate == Predicate::Color ? category->colors : category->materials;
    const std::string value = choose(values, symbol, truth);
    if (value.empty()) return impossible();
    field = value;
  } else if (predicate == Predicate::Covered) {
    if (!knowledge.has(node.category, "coverable")) return impossible();
    if (truth) {
      node.states.set({Predicate::Covered, symbol == "any" ? "dust" : symbol});
    } else {
      node.states.clear(Predicate::Covered);
    }
  } else {
    const StateGroup* group = group_with(predicate);
    if (group == nullptr) {
      return fail(RejectionReason::CannotEnforce, "no edit of a scene makes a thing " + state_text);
    }
    if (!knowledge.has(node.category, group->affordance)) return impossible();
    Predicate value = predicate;
    if (!truth) value = group->predicates[predicate == group->predicates.front() ? 1 : 0];
    std::string filling;
    if (value == Predicate::Filled) {
      Rng rng = next_rng();
      filling = truth && symbol != "any" ? symbol : draw_filling(node.category, knowledge, rng);
      if (filling.empty() || filling == symbol) filling = truth && symbol != "any" ? symbol : "water";
    }
    node.states.set({value, filling});
    if (value == Predicate::Dirty) unfold_if_dirty(node);
    if (group->affordance == "openable") {
      const Node original = workspace_.scene().nodes[*index];
      workspace_.replace(*index, std::move(node));
      stale_ = true;
      if (!open_or_close(id, value == Predicate::Open ? 1 : 0)) {
        workspace_.replace(*index_of(id), original);
        return false;
      }
      return true;
    }
  }
  workspace_.replace(*index, std::move(node));
  stale_ = true;
  return true;
}

bool SceneEditor::open_or_close(const std::string& id, double opening) {
  const Node before = workspace_.scene().nodes[*index_of(id)];
  const Shape shape = shape_of(before);
  // What lies in a drawer rides along.
  std::vector<std::string> riders, carried;
  if (std::any_of(shape.cavities.begin(), shape.cavities.end(), [](const Cavity& one) { return one.joint >= 0; })) {
    refresh();
    carried = workspace_.carried_by(*index_of(id));
  }
  for (const Cavity& cavity : shape.cavities) {
    if (cavity.joint < 0) continue;
    const Pose from = before.pose * joint_motion(shape, cavity.joint, before.opening);
    const Pose to = before.pose * joint_motion(shape, cavity.joint, opening);
    for (const std::string& rider : carried) {
      const Node& node = workspace_.scene().nodes[*index_of(rider)];
      const Vec3 local = inverse(from) * node.pose.position - cavity.center;
      if ((local.cwiseAbs() - cavity.half).maxCoeff() > 0) continue;
      move_to(rider, to * (inverse(from) * node.pose));
      riders.push_back(rider);
    }
  }
  Node after = before;
  after.opening = opening;
  workspace_.replace(*index_of(id), after);
  stale_ = true;
  // What stands where the door comes to be goes elsewhere; so does a small thing whose lid has no room.
  for (int round = 0; round < 5; ++round) {
    const Node& now = workspace_.scene().nodes[*index_of(id)];
    std::vector<BodyId> ignore{BodyId::node(*index_of(id))};
    for (const std::string& rider : riders) ignore.push_back(BodyId::node(*index_of(rider)));
    const auto hit = workspace_.checker().hit_by_joints(shape, now.pose, opening, PlacementChecker::kGap_m, ignore);
    if (!hit) return true;
    const std::string obstacle = workspace_.name_of(*hit);
    const bool movable = hit->is_node() && workspace_.scene().nodes[hit->index()].movable;
    bool made_room = false;
    if (before.movable) {
      made_room = relocate(id, [&](const Node& host) { return host.id != obstacle; });
    } else if (movable) {
      made_room = relocate(obstacle, [&](const Node& host) { return host.id != id; });
    }
    if (!made_room) return fail(RejectionReason::NoFreePlace, "the door of " + before.category + " hits " + obstacle);
  }
  return fail(RejectionReason::NoFreePlace, "the door of " + before.category + " has no room");
}

}  // namespace unietp
