#pragma once

#include <vector>

#include "logic/trace.h"
#include "scene/scene.h"
#include "symbolic/goal.h"

namespace unietp::symbolic {

/// A physical scene, or a part of it, without its geometry. Does not move: the setting points to the rules.
struct SceneSymbols {
  Rules rules;
  Setting setting;
  World start;
  Trace seen;            // the scene's own facts, from which `:where` is read
  std::vector<Id> cast;  // by entity of `seen`; kNobody for what was left out

  /// `nodes` are of the scene and of categories that the knowledge base has; with each is what it rests on or in. The
  /// agent stands by nothing yet.
  SceneSymbols(const Scene& scene, const Knowledge& knowledge, ActionProfile profile,
               const std::vector<const Node*>& nodes);
  SceneSymbols(const SceneSymbols&) = delete;
  SceneSymbols& operator=(const SceneSymbols&) = delete;

  Goal goal(const Formula& formula) const { return {formula, setting, start, {&seen, &cast}}; }
};

/// What a node rests on or in directly; nullptr for what stands on a floor or is held.
const Node* support_of(const Scene& scene, const Node& node);

}  // namespace unietp::symbolic
