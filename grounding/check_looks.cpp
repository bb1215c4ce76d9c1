#include "grounding/check_looks.h"

#include <algorithm>

#include "generator/goal_variable.h"
#include "grounding/goal_places.h"
#include "simulation/contrast.h"

namespace unietp {
namespace {

/// Which of the pairs of a thing that is meant and one that is not looks alike by what the words say of them.
std::optional<std::string> alike(const std::vector<const Node*>& referents, const std::vector<const Node*>& others,
                                 const std::set<Predicate>& predicates, Simulator simulator) {
  std::vector<std::pair<Node, Node>> seen;  // pairs that are told apart
  for (const Node* one : referents) {
    for (const Node* other : others) {
      for (const Predicate predicate : predicates) {
        Node shown = *one;
        shown.id = shown.category;  // what two things of a category differ in besides is not what the words say
        shown.pose = Pose{};
        const auto changed = with_look_of(shown, *other, predicate);
        if (!changed || std::find(seen.begin(), seen.end(), std::pair(shown, *changed)) != seen.end()) continue;
        if (!distinguishable(contrast_of(shown, *changed, simulator)))
          return one->id + " and " + other->id + " by " + std::string(info(predicate).name);
        seen.emplace_back(std::move(shown), *changed);
      }
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<GroundingFailure> check_looks(const Specification& specification, const Scene& start,
                                            const NodeIndex& places, const Trace& trace) {
  if (specification.split != Split::InstanceGrounding && specification.refinement == Referring::None)
    return std::nullopt;
  const auto nodes_of = [&](const std::vector<EntityIndex>& entities) {
    std::vector<const Node*> nodes;
    for (const EntityIndex entity : entities)
      if (const auto place = places.find(trace.entities[entity].id)) nodes.push_back(&start.nodes[*place]);
    return nodes;
  };
  for (const ReferredThings& one : referred_things(specification.goal, trace)) {
    const auto predicates = predicates_in(one.domain.domain.where.front());
    if (const auto pair = alike(nodes_of(one.referents), nodes_of(one.others), predicates, specification.simulator))
      return GroundingFailure{RejectionReason::LooksAlike, "pictures do not tell " + *pair, {}};
  }
  return std::nullopt;
}

}  // namespace unietp
