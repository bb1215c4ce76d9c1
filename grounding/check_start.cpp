#include "grounding/check_start.h"

#include <algorithm>

#include "generator/goal_parts.h"
#include "grounding/goal_places.h"
#include "logic/evaluate.h"
#include "scene/trace.h"
#include "simulation/navigation.h"
#include "simulation/physics.h"
#include "simulation/relations.h"

namespace unietp {
namespace {

using Op = Formula::Op;

constexpr double kCalm_m = 0.005;

GroundingFailure failure(GroundingReason reason, std::string detail) { return {reason, std::move(detail), {}}; }

bool makes_slices(const Domain& domain) {
  return std::any_of(domain.members.begin(), domain.members.end(), [](const auto& member) { return member.slice; });
}

/// Asks whether the body can stand where it reaches and sees a thing, behind doors that it can open too.
class Reach {
 public:
  Reach(const Scene& scene, const PhysicsWorld& world, const Profile& profile)
      : scene_(scene),
        world_(world),
        profile_(profile),
        grid_(scene, profile),
        walk_(grid_.distances(grid_.cell_at(scene.agent.position))) {}

  bool room(const Room& room) const {
    for (int y = 0; y < grid_.height(); ++y) {
      for (int x = 0; x < grid_.width(); ++x) {
        const auto at =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(grid_.width()) + static_cast<std::size_t>(x);
        if (walk_[at] >= 0 && contains(room.polygon, grid_.centre({x, y}))) return true;
      }
    }
    return false;
  }

  bool object(std::size_t index) const {
    if (standing_place(scene_, world_, grid_, walk_, profile_, index)) return true;
    // Behind doors: each must be reachable shut, and the thing with all of them open.
    Scene opened = scene_;
    PhysicsWorld opened_world = world_;
    bool any = false;
    for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
      const Node& container = scene_.nodes[i];
      const bool shut = container.openable && container.opening < 0.5;
      if (!shut || !has_edge(scene_, Predicate::Inside, scene_.nodes[index].id, container.id)) continue;
      any = true;
      if (!object(i)) return false;
      opened.nodes[i].opening = 1;
      opened_world.set(static_cast<BodyId>(i), shape_of(container), container.pose, 1, container.mass);
    }
    if (!any) return false;
    slide_along(opened, opened_world, index);
    const NavigationGrid grid(opened, profile_);
    const auto walk = grid.distances(grid.cell_at(opened.agent.position));
    return standing_place(opened, opened_world, grid, walk, profile_, index).has_value();
  }

 private:
  /// Moves a thing with the drawer that it lies in.
  void slide_along(Scene& opened, PhysicsWorld& world, std::size_t index) const {
    Node& thing = opened.nodes[index];
    for (const Node& container : scene_.nodes) {
      if (!has_edge(scene_, Predicate::Inside, thing.id, container.id)) continue;
      const Shape shape = shape_of(container);
      for (const Cavity& cavity : shape.cavities) {
        if (cavity.joint < 0 || container.opening > 0.5) continue;
        const Pose motion = joint_motion(shape, cavity.joint, 1);
        thing.pose = container.pose * (motion * (inverse(container.pose) * thing.pose));
        world.move(static_cast<BodyId>(index), thing.pose);
      }
    }
  }

  const Scene& scene_;
  const PhysicsWorld& world_;
  const Profile& profile_;
  NavigationGrid grid_;
  std::vector<std::int32_t> walk_;
};

std::optional<GroundingFailure> check_formulas(const Specification& specification, const Trace& trace) {
  for (const Formula& constraint : specification.init) {
    if (!holds_in(constraint, trace, 0)) {
      return failure(GroundingReason::StartNotMet, "the start constraint " + to_text(constraint) + " does not hold");
    }
  }
  if (holds(specification.goal, trace)) {
    return failure(GroundingReason::GoalHolds, to_text(specification.goal) + " holds at the start");
  }
  for (const Formula& part : goal_parts(specification.goal)) {
    if (holds(part, trace)) {
      return failure(GroundingReason::PartHolds, "the part " + to_text(part) + " holds at the start");
    }
  }
  for (const std::string& domain : empty_domains(specification.goal, trace)) {
    if (domain.find("/slice") == std::string::npos) {  // slices are there once something is cut
      return failure(GroundingReason::EmptyDomain, "the domain " + domain + " is empty");
    }
  }
  return std::nullopt;
}

bool tells_apart(const Specification& specification) {
  return specification.split == Split::InstanceGrounding || !specification.refinement.empty();
}

std::optional<GroundingFailure> check_referring(const Specification& specification, const Trace& trace) {
  for (const QuantifiedDomain& one : quantified_domains(specification.goal)) {
    if (!one.certain) continue;
    if (one.domain.where.empty() || !free_variables(one.domain.where.front()).empty()) {
      const auto free =
          one.domain.where.empty() ? std::vector<std::string>{} : free_variables(one.domain.where.front());
      const bool own_only =
          std::all_of(free.begin(), free.end(), [&](const auto& name) { return name == one.variable; });
      if (one.domain.where.empty() || !own_only) continue;
    }
    Domain all = one.domain;
    all.where.clear();
    const auto referents = members_of(one.domain, one.variable, trace).size();
    const auto candidates = members_of(all, one.variable, trace).size();
    if (referents == 0) {
      return failure(GroundingReason::NoReferent, "nothing satisfies " + to_text(one.domain));
    }
    if (tells_apart(specification) && candidates == referents) {
      return failure(GroundingReason::NoDistractor, to_text(one.domain) + " excludes nothing");
    }
  }
  return std::nullopt;
}

/// Of the domain of one quantifier: how many members have to be within reach for the goal to be possible.
std::size_t needed(const QuantifiedDomain& one, std::size_t members) {
  return one.op == Op::Exists ? std::min<std::size_t>(1, members) : members;
}

std::optional<GroundingFailure> check_reach(const Specification& specification, const Scene& start,
                                            const PhysicsWorld& world, const Trace& trace, const Profile& profile) {
  const Reach reach(start, world, profile);
  const auto check = [&](const QuantifiedDomain& one, std::size_t wanted,
                         const std::vector<EntityIndex>& members) -> std::optional<GroundingFailure> {
    std::size_t reached = 0;
    std::string missed;
    for (const EntityIndex entity : members) {
      if (reached >= wanted) break;
      const Entity& thing = trace.entities[entity];
      bool near = thing.kind == Entity::Kind::Agent;
      if (thing.kind == Entity::Kind::Room) near = reach.room(*find_room(start, thing.id));
      if (thing.kind == Entity::Kind::Object) {
        near = reach.object(static_cast<std::size_t>(find_node(start, thing.id) - start.nodes.data()));
      }
      if (near) {
        ++reached;
      } else {
        missed = thing.id;
      }
    }
    if (reached >= wanted) return std::nullopt;
    auto problem = failure(GroundingReason::NotReachable, "of " + to_text(one.domain) + " " + std::to_string(reached) +
                                                              " can be reached, " + std::to_string(wanted) +
                                                              " are needed; " + missed + " cannot");
    problem.subject = missed;
    return problem;
  };
  for (const QuantifiedDomain& one : quantified_domains(specification.goal)) {
    if (makes_slices(one.domain)) continue;
    Domain domain = one.domain;
    if (!domain.where.empty()) {
      const auto free = free_variables(domain.where.front());
      const bool own_only =
          std::all_of(free.begin(), free.end(), [&](const auto& name) { return name == one.variable; });
      if (!own_only) domain.where.clear();
    }
    const auto members = members_of(domain, one.variable, trace);
    if (auto problem = check(one, needed(one, members.size()), members)) return problem;
  }
  for (const Formula& constraint : specification.init) {
    if (constraint.op != Op::Exists && constraint.op != Op::Count) continue;
    const QuantifiedDomain one{constraint.op, constraint.variable, constraint.domain, true};
    const auto members = members_of(constraint.domain, constraint.variable, trace);
    if (auto problem = check(one, std::min<std::size_t>(1, members.size()), members)) return problem;
  }
  return std::nullopt;
}

std::optional<GroundingFailure> check_calm(const Scene& start, const std::set<std::string>& touched,
                                           const PhysicsWorld& world) {
  for (std::size_t i = 0; i < start.nodes.size(); ++i) {
    const Node& node = start.nodes[i];
    if (!node.movable || !touched.contains(node.id)) continue;
    const BodyId loose[] = {static_cast<BodyId>(i)};
    const Settled settled = world.settle(loose);
    const double moved = (settled.bodies.front().pose.position - node.pose.position).norm();
    if (!settled.calm || moved > kCalm_m) {
      return failure(GroundingReason::NotCalm,
                     node.id + " moves " + std::to_string(static_cast<int>(moved * 1000)) + " mm when let go");
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<GroundingFailure> check_start(const Specification& specification, const Scene& start,
                                            const std::set<std::string>& touched, const Profile& profile) {
  const PhysicsWorld world = physics_of(start);
  Scene read = start;
  read.edges = read_relations(start, world);
  bool compared = reads_comparisons(specification.goal);
  for (const Formula& constraint : specification.init) compared = compared || reads_comparisons(constraint);
  const Trace trace = to_logic(read, {}, compared);
  if (auto problem = check_formulas(specification, trace)) return problem;
  if (auto problem = check_referring(specification, trace)) return problem;
  if (auto problem = check_calm(read, touched, world)) return problem;
  return check_reach(specification, read, world, trace, profile);
}

}  // namespace unietp
