#include "grounding/check_start.h"

#include <algorithm>

#include "generator/goal_parts.h"
#include "grounding/check_goal.h"
#include "grounding/check_looks.h"
#include "grounding/check_references.h"
#include "grounding/check_seeming.h"
#include "grounding/goal_places.h"
#include "grounding/nearness_on_foot.h"
#include "grounding/reach.h"
#include "logic/evaluate.h"
#include "scene/comparisons.h"
#include "simulation/physics.h"
#include "simulation/relations.h"
#include "simulation/standing.h"

namespace unietp {
namespace {

using Op = Formula::Op;

constexpr double kCalm_m = 0.005;

GroundingFailure failure(RejectionReason reason, std::string detail) { return {reason, std::move(detail), {}}; }

std::optional<GroundingFailure> check_formulas(const Specification& specification, const Trace& trace) {
  for (const Formula& constraint : specification.init) {
    if (!holds_in(constraint, trace, 0)) {
      return failure(RejectionReason::StartNotMet, "the start constraint " + to_text(constraint) + " does not hold");
    }
  }
  if (holds(specification.goal, trace)) {
    return failure(RejectionReason::GoalHolds, to_text(specification.goal) + " holds at the start");
  }
  for (const Formula& part : goal_parts(specification.goal)) {
    if (holds(part, trace)) {
      return failure(RejectionReason::PartHolds, "the part " + to_text(part) + " holds at the start");
    }
  }
  for (const std::string& domain : empty_domains(specification.goal, trace)) {
    if (domain.find("/slice") == std::string::npos) {  // slices are there once something is cut
      return failure(RejectionReason::EmptyDomain, "the domain " + domain + " is empty");
    }
  }
  return std::nullopt;
}

bool tells_apart(const Specification& specification) {
  return specification.split == Split::InstanceGrounding || specification.refinement != Referring::None;
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
      return failure(RejectionReason::NoReferent, "nothing satisfies " + to_text(one.domain));
    }
    if (tells_apart(specification) && candidates == referents) {
      return failure(RejectionReason::NoDistractor, to_text(one.domain) + " excludes nothing");
    }
  }
  return std::nullopt;
}

/// Of the domain of one quantifier: how many members have to be within reach for the goal to be possible.
std::size_t needed(const QuantifiedDomain& one, std::size_t members) {
  return one.op == Op::Exists ? std::min<std::size_t>(1, members) : members;
}

std::optional<GroundingFailure> check_reach(const Specification& specification, const Scene& start,
                                            const NodeIndex& places, const Trace& trace, Reach& reach) {
  const auto check = [&](const QuantifiedDomain& one, std::size_t wanted,
                         const std::vector<EntityIndex>& members) -> std::optional<GroundingFailure> {
    std::size_t reached = 0;
    std::string missed;
    const auto look_at = [&](EntityIndex entity) {
      const Entity& thing = trace.entities[entity];
      bool near = thing.kind == Entity::Kind::Agent;
      if (thing.kind == Entity::Kind::Room) near = reach.room(*find_room(start, thing.id));
      if (thing.kind == Entity::Kind::Object) near = reach.object(places.find(thing.id).value());
      if (near) {
        ++reached;
      } else {
        missed = thing.id;
      }
    };
    // Behind doors the way of the body is looked for anew: what lies there is asked last, if at all.
    std::vector<EntityIndex> shut_away;
    for (const EntityIndex entity : members) {
      if (reached >= wanted) break;
      const auto place = wanted < members.size() ? places.find(trace.entities[entity].id) : std::nullopt;
      if (place && !reach.lies_open(*place)) {
        shut_away.push_back(entity);
      } else {
        look_at(entity);
      }
    }
    for (const EntityIndex entity : shut_away) {
      if (reached >= wanted) break;
      look_at(entity);
    }
    if (reached >= wanted) return std::nullopt;
    auto problem = failure(RejectionReason::NotReachable, "of " + to_text(one.domain) + " " + std::to_string(reached) +
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
    const std::size_t wanted = needed(one, members.size());
    if (auto problem = check(one, wanted, members)) return problem;
  }
  for (const Formula& constraint : specification.init) {
    if (constraint.op != Op::Exists && constraint.op != Op::Count) continue;
    const QuantifiedDomain one{constraint.op, constraint.variable, constraint.domain, true};
    const auto members = members_of(constraint.domain, constraint.variable, trace);
    // What has to be there k times is needed k times: one for each place, both to be swapped.
    const bool counted = constraint.op == Op::Count &&
                         (constraint.comparison == Comparison::Equal || constraint.comparison == Comparison::AtLeast);
    const std::size_t wanted = counted ? static_cast<std::size_t>(std::max(1, constraint.number)) : 1;
    const std::size_t least = std::min(wanted, members.size());
    if (auto problem = check(one, least, members)) return problem;
  }
  return std::nullopt;
}

std::optional<GroundingFailure> check_calm(const Scene& start, const NodeIndex& places,
                                           const std::set<std::string>& touched, const PhysicsWorld& world) {
  std::vector<std::size_t> there;
  for (const std::string& id : touched) {
    if (const auto place = places.find(id)) there.push_back(*place);
  }
  std::sort(there.begin(), there.end());
  for (const std::size_t i : there) {
    const Node& node = start.nodes[i];
    if (!node.movable) continue;
    const BodyId loose[] = {BodyId::node(i)};
    const Settled settled = world.settle(loose);
    const double moved = (settled.bodies.front().pose.position - node.pose.position).norm();
    if (!settled.calm || moved > kCalm_m) {
      return failure(RejectionReason::NotCalm,
                     node.id + " moves " + std::to_string(static_cast<int>(moved * 1000)) + " mm when let go");
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<GroundingFailure> check_start(const Specification& specification, const Home& home, const Scene& start,
                                            const GrownScene& grown, const std::set<std::string>& touched,
                                            const Knowledge& knowledge, const Profile& profile,
                                            const StartGates& gates) {
  if (grown.edges.applied_to(home.scene.edges) != start.edges)
    return failure(RejectionReason::StartNotMet, "the relations of the start are not those that physics shows");
  Compared compared;
  compared.add(specification.goal);
  for (const Formula& constraint : specification.init) compared.add(constraint);
  Trace trace = grown.now;
  Facts& facts = trace.states.front();
  if (!compared.none()) facts = with_comparisons(facts, start, grown.reader, compared);
  if (auto problem = check_formulas(specification, trace)) return problem;
  if (auto problem = check_referring(specification, trace)) return problem;
  if (gates.natural) {
    if (auto problem = check_references(specification, trace)) return problem;
    if (auto problem = check_seeming(specification.goal, trace, knowledge)) return problem;
    if (auto problem = check_nearness_on_foot(specification.goal, start, grown.places, trace, *grown.walk))
      return problem;
  }
  Reach reach(home, start, grown, profile);
  if (auto problem = check_reach(specification, start, grown.places, trace, reach)) return problem;
  if (auto problem = check_goal(specification, start, grown.places, trace, knowledge, profile, reach, gates.pictured))
    return problem;
  if (const auto room = reach.unreached())
    return GroundingFailure{RejectionReason::NotReachable, *room + " cannot be walked to any more", *room};
  if (auto problem = check_looks(specification, start, grown.places, trace)) return problem;
  return check_calm(start, grown.places, touched, grown.physics);  // costs most, and seldom finds something
}

}  // namespace unietp
