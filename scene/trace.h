#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "logic/formula.h"
#include "logic/trace.h"
#include "scene/scene.h"

namespace unietp {

/// What one action changed. `apply(before, difference(before, after)) == after`.
struct Delta {
  std::vector<Node> nodes;           // new or changed, whole
  std::vector<std::string> removed;  // ids of nodes that are gone
  std::vector<Edge> edges_added, edges_removed;
  std::optional<Agent> agent;
  /// Whether nothing changed.
  bool empty() const;
  bool operator==(const Delta&) const = default;
};
/// What changed from one scene to another of the same home. Node order and rooms are not compared.
Delta difference(const Scene& before, const Scene& after);
/// Changed nodes keep their place, new ones are appended in order. Rooms and openings never change.
Scene apply(Scene before, const Delta& delta);

/// The agent, in all that a FactReader reads.
inline constexpr EntityIndex kAgentEntity(0);

/// Turns scenes of one episode into states of the logic, one after the other, over one growing list of entities: the
/// agent, the rooms, then the nodes in order of first appearance. Also the facts that follow from others: a node's
/// color, material; `held`; and, only when asked for because the cost is quadratic, what comes of comparing things of
/// one category: `size` (a thing without a second of its category has none) and `nearest`.
class FactReader {
 public:
  explicit FactReader(bool with_comparisons = false);
  /// All facts of a scene. Entities that are new are appended; none is ever removed.
  Facts read(const Scene& scene);
  /// The facts after a change, at the cost of the change: what `read` of the changed scene would give, but with the
  /// comparisons of the things as they were before.
  Facts read(Facts before, const Delta& change);
  /// Copies made from now on have all entities up to here in common.
  void share();
  /// All entities so far; indices stay valid.
  const EntityList& entities() const { return entities_; }
  /// The entity with this id; nullopt when it was never read.
  std::optional<EntityIndex> find(std::string_view id) const;

 private:
  EntityIndex index_of(Entity entity);
  EntityIndex add_node(const Node& node, Facts& facts);
  bool with_comparisons_;
  EntityList entities_;
  std::unordered_map<std::string, EntityIndex> by_id_;  // of those that are not shared
};

/// Whether a formula or one of its domains speaks of `size` or `nearest`.
bool reads_comparisons(const Formula& formula);
/// Whether it does so outside of its domains' `:where`, which are read at the start only.
bool reads_later_comparisons(const Formula& formula);

/// The whole trace of a start scene and its deltas.
Trace to_logic(const Scene& start, const std::vector<Delta>& deltas, bool with_comparisons = false);

}  // namespace unietp
