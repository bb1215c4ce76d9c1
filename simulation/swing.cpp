#include "simulation/swing.h"

#include <algorithm>

#include "simulation/relations.h"
#include "simulation/standing.h"
#include "simulation/world_state.h"

namespace unietp {
namespace {

constexpr int kSweepSteps = 8;
constexpr double kScrape_m =
    0.003;  // a door may overlap its surroundings by this much (resting contacts sink a little)

Shape moving_parts(const Shape& shape) {
  Shape moving;
  moving.joints = shape.joints;
  for (const Part& part : shape.parts) {
    if (part.joint >= 0) moving.parts.push_back(part);
  }
  return moving;
}

/// Contents of cavities that move with a joint.
std::vector<std::size_t> riders(const WorldState& state, std::size_t node, const Shape& shape) {
  std::vector<std::size_t> riding;
  const bool slides =
      std::any_of(shape.cavities.begin(), shape.cavities.end(), [](const Cavity& c) { return c.joint >= 0; });
  if (!slides) return riding;
  for (const std::uint32_t content : state.carried(node)) {
    if (!state.linked(content, Predicate::Inside, node)) continue;
    const auto group = state.group_of(content);
    riding.insert(riding.end(), group.begin(), group.end());
  }
  std::sort(riding.begin(), riding.end());
  riding.erase(std::unique(riding.begin(), riding.end()), riding.end());
  return riding;
}

}  // namespace

std::optional<BodyId> joint_obstacle(const PhysicsWorld& world, const Node& node, const Shape& shape, double to,
                                     std::span<const BodyId> ignore) {
  const Shape moving = moving_parts(shape);
  for (int step = 1; step <= kSweepSteps; ++step) {
    const double opening = node.opening + (to - node.opening) * step / kSweepSteps;
    if (const auto hit = world.overlap(moving, node.pose, opening, ignore, kScrape_m)) return hit;
  }
  return std::nullopt;
}

ActionResult swing(WorldState& state, std::size_t i, bool open) {
  if (!state.node(i).openable) return failed(FailureCause::NotOpenable, state.reference(i));
  if (state.held(state.node(i).id)) return failed(FailureCause::MustBePutDown, state.reference(i));
  if (auto blocked = access_failure(state, i)) return *blocked;
  const bool is_open = state.node(i).states.has(Predicate::Open);
  if (open && is_open) return failed(FailureCause::AlreadyOpen, state.reference(i));
  if (!open && !is_open) return failed(FailureCause::AlreadyClosed, state.reference(i));
  if (open && state.profile->open_needs_power_off && state.node(i).states.has(Predicate::PowerOn)) {
    return failed(FailureCause::StillRunning, state.reference(i));
  }

  const Shape& shape = state.collider(i).shape;  // independent of the opening
  const double from = state.node(i).opening, to = open ? 1.0 : 0.0;
  const std::vector<std::size_t> riding = riders(state, i, shape);
  if (!shape.joints.empty()) {
    std::vector<BodyId> ignore{BodyId::node(i)};
    for (const std::size_t rider : riding) ignore.push_back(BodyId::node(rider));
    if (const auto hit = joint_obstacle(state.physics(), state.node(i), shape, to, ignore))
      return failed(FailureCause::JointBlocked, state.reference(i), state.reference_to_body(*hit));
    if (in_door_sweep(state.node(i), state.agent().position, *state.profile)) {
      return failed(FailureCause::AgentInTheWay, state.reference(i));
    }
  }

  look_at(state, state.node(i).pose.position);
  std::vector<std::size_t> changed{i};
  std::vector<Bounds> touched{state.physics().bounds(BodyId::node(i))};
  if (!riding.empty()) {
    const int joint =
        std::find_if(shape.cavities.begin(), shape.cavities.end(), [](const Cavity& c) { return c.joint >= 0; })->joint;
    const Pose& pose = state.node(i).pose;
    const Pose motion =
        pose * joint_motion(shape, joint, to) * inverse(joint_motion(shape, joint, from)) * inverse(pose);
    for (const std::size_t rider : riding) {
      touched.push_back(state.physics().bounds(BodyId::node(rider)));
      state.move(rider, motion * state.node(rider).pose);
      touched.push_back(state.physics().bounds(BodyId::node(rider)));
      changed.push_back(rider);
    }
  }
  state.edit_states(i).set({open ? Predicate::Open : Predicate::Closed, ""});
  state.set_opening(i, to);
  touched.push_back(state.physics().bounds(BodyId::node(i)));
  state.carry_along();
  state.refresh(touched, changed);
  run_processes(state, i);
  return succeeded();
}

}  // namespace unietp
