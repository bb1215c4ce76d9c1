#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "logic/trace.h"
#include "scene/scene.h"

namespace unietp {

/// What one action changed. `apply(before, difference(before, after)) == after`.
struct Delta {
  std::vector<Node> nodes;           // new or changed, whole
  std::vector<std::string> removed;  // ids of nodes that are gone
  std::vector<Edge> edges_added, edges_removed;
  std::optional<Agent> agent;
  bool empty() const;
  bool operator==(const Delta&) const = default;
};
Delta difference(const Scene& before, const Scene& after);
/// Changed nodes keep their place, new ones are appended in order. Rooms and openings never change.
Scene apply(Scene before, const Delta& delta);

/// Turns scenes of one episode into states of the logic, one after the other, over one growing list of entities: the
/// agent, the rooms, then the nodes in order of first appearance. Also the facts that follow from others: a node's
/// colour, material; `held`; `nearest` (x is the one of its category whose centre is nearest to y, ties by order),
/// which is quadratic and only read when asked for.
class FactReader {
 public:
  explicit FactReader(bool with_nearest = false);
  Facts read(const Scene& scene);
  const std::vector<Entity>& entities() const { return entities_; }

 private:
  std::optional<EntityIndex> find(std::string_view id) const;
  EntityIndex index_of(Entity entity);
  bool with_nearest_;
  std::vector<Entity> entities_;
  std::vector<std::pair<std::string, EntityIndex>> by_id_;  // sorted by id
};

/// The whole trace of a start scene and its deltas.
Trace to_logic(const Scene& start, const std::vector<Delta>& deltas, bool with_nearest = false);

}  // namespace unietp
