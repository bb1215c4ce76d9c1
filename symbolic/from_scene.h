#pragma once

#include <vector>

#include "logic/trace.h"
#include "scene/scene.h"
#include "symbolic/goal.h"

namespace unietp::symbolic {

/// A physical scene, or a part of it, as symbols without geometry. Cannot be copied or moved: the setting points to the
/// rules.
struct SceneSymbols {
  Rules rules;
  Setting setting;
  World start;
  Trace seen;               // the scene's own facts, from which `:where` is read
  std::vector<Id> objects;  // by entity of `seen`; kNobody for what was left out

  /// `nodes` must be nodes of the scene, of categories that the knowledge base has, each together with what it rests on
  /// or in. At the start the agent has gone to nothing yet.
  SceneSymbols(const Scene& scene, const Knowledge& knowledge, ActionProfile profile,
               const std::vector<const Node*>& nodes);
  SceneSymbols(const SceneSymbols&) = delete;
  SceneSymbols& operator=(const SceneSymbols&) = delete;

  /// The formula over these things. The result refers to this value.
  Goal goal(const Formula& formula) const { return {formula, setting, start, {&seen, &objects}}; }
};

/// What a node rests on or in directly; nullptr for what stands on a floor or is held.
const Node* support_of(const Scene& scene, const Node& node);

}  // namespace unietp::symbolic
