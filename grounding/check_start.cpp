#include "grounding/check_start.h"

#include <algorithm>

#include "generator/goal_parts.h"
#include "grounding/goal_places.h"
#include "grounding/present.h"
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
  Reach(const Home& home, const Scene& scene, const PhysicsWorld& world, const Profile& profile)
      : home_(home), scene_(scene), world_(world), profile_(profile), walk_(walk_of(home, scene)) {}

  bool room(const Room& room) const {
    const NavigationGrid& grid = walk_->grid;
    for (int y = 0; y < grid.height(); ++y) {
      for (int x = 0; x < grid.width(); ++x) {
        if (walk_->steps[grid.index({x, y})] >= 0 && contains(room.polygon, grid.centre({x, y}))) return true;
      }
    }
    return false;
  }

  bool object(std::size_t index) {
    const std::vector<std::size_t> doors = shut_around(index);
    if (doors.empty()) return standing_place(scene_, world_, walk_->grid, walk_->steps, profile_, index).has_value();
    // Each door must be reachable shut, and the thing with all of them open.
    if (!std::all_of(doors.begin(), doors.end(), [&](std::size_t door) { return object(door); })) return false;
    Opened& opened = with_open(doors);
    const Pose before = opened.scene.nodes[index].pose;
    slide_along(opened, doors, index);
    const bool reached =
        standing_place(opened.scene, opened.world, opened.walk->grid, opened.walk->steps, profile_, index).has_value();
    place(opened, index, before);
    return reached;
  }

 private:
  /// The scene with some doors open.
  struct Opened {
    std::vector<std::size_t> doors;
    Scene scene;
    PhysicsWorld world;
    std::shared_ptr<const Walk> walk;
  };

  std::vector<std::size_t> shut_around(std::size_t index) const {
    std::vector<std::size_t> doors;
    for (const Edge& edge : scene_.edges) {
      if (edge.relation != Predicate::Inside || edge.from != scene_.nodes[index].id) continue;
      const Node* container = find_node(scene_, edge.to);
      if (container != nullptr && container->openable && container->opening < 0.5)
        doors.push_back(static_cast<std::size_t>(container - scene_.nodes.data()));
    }
    return doors;
  }

  Opened& with_open(const std::vector<std::size_t>& doors) {
    if (opened_ && opened_->doors == doors) return *opened_;
    opened_ = Opened{doors, scene_, world_, nullptr};
    for (const std::size_t door : doors) {
      const Node& container = scene_.nodes[door];
      opened_->scene.nodes[door].opening = 1;
      opened_->world.set(static_cast<BodyId>(door), shape_of(container), container.pose, 1, container.mass);
    }
    opened_->walk = walk_of(home_, opened_->scene);
    return *opened_;
  }

  static void place(Opened& opened, std::size_t index, const Pose& pose) {
    opened.scene.nodes[index].pose = pose;
    opened.world.move(static_cast<BodyId>(index), pose);
  }

  /// Moves a thing with the drawer that it lies in.
  void slide_along(Opened& opened, const std::vector<std::size_t>& doors, std::size_t index) const {
    for (const std::size_t door : doors) {
      const Node& container = scene_.nodes[door];
      const Shape shape = shape_of(container);
      for (const Cavity& cavity : shape.cavities) {
        if (cavity.joint < 0) continue;
        const Pose motion = joint_motion(shape, cavity.joint, 1);
        const Pose& pose = opened.scene.nodes[index].pose;
        place(opened, index, container.pose * (motion * (inverse(container.pose) * pose)));
      }
    }
  }

  const Home& home_;
  const Scene& scene_;
  const PhysicsWorld& world_;
  const Profile& profile_;
  std::shared_ptr<const Walk> walk_;
  std::optional<Opened> opened_;  // the last asked for
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

std::optional<GroundingFailure> check_reach(const Specification& specification, const Home& home, const Scene& start,
                                            const PhysicsWorld& world, const Trace& trace, const Profile& profile) {
  Reach reach(home, start, world, profile);
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

std::optional<GroundingFailure> check_start(const Specification& specification, const Home& home, const Scene& start,
                                            const std::set<std::string>& touched, const Profile& profile) {
  const PhysicsWorld world = physics_of(home, start);
  const GrownScene read = read_grown(home, start, world);
  if (read.edges != start.edges)
    return failure(GroundingReason::StartNotMet, "the relations of the start are not those that physics shows");
  bool compared = reads_comparisons(specification.goal);
  for (const Formula& constraint : specification.init) compared = compared || reads_comparisons(constraint);
  const Trace trace = compared ? to_logic(start, {}, true) : read.now;
  if (auto problem = check_formulas(specification, trace)) return problem;
  if (auto problem = check_referring(specification, trace)) return problem;
  if (auto problem = check_calm(start, touched, world)) return problem;
  return check_reach(specification, home, start, world, trace, profile);
}

}  // namespace unietp
