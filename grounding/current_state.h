#pragma once

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "grounding/home.h"
#include "scene/edge_change.h"
#include "scene/node_index.h"
#include "scene/trace.h"
#include "simulation/relations.h"

namespace unietp {

/// What physics and the logic show of a scene that grew out of a home, kept up to date at the cost of what changed
/// since it was last read; without comparisons (`nearest`, `size`). Relations are kept as facts; the scene's own edges
/// are not looked at.
class CurrentState {
 public:
  /// Of the home as it is, which must outlive it.
  explicit CurrentState(const Home& home);

  /// A node came, went or changed; `bounds`: of its body before, or now.
  void touch(const std::string& id, const Bounds& bounds);
  /// A node changed in what no body shows.
  void touch(const std::string& id);
  /// Reads what can have changed. `places`: of the scene's nodes.
  void read(const Scene& scene, const NodeIndex& places, const PhysicsWorld& physics);

  /// The state that was read last. Entities that are gone stay in the list and do not exist.
  const Trace& now() const { return trace_; }
  const FactReader& reader() const { return reader_; }  // that read it
  /// The edges that start at a thing, sorted, as last read.
  std::vector<Edge> edges_from(std::string_view id) const;
  /// How the edges as last read differ from the home's.
  EdgeChange since_home() const;
  /// Of the nodes whose relations were read last, with their places in the scene.
  using NodeLinks = std::vector<std::pair<std::size_t, std::vector<Link>>>;
  const NodeLinks& links_read() const { return links_read_; }
  /// Ids of all things that were ever touched, those since the last reading aside.
  const std::set<std::string>& ever_touched() const { return ever_touched_; }

 private:
  const Home* home_;
  FactReader reader_;
  Trace trace_;
  Agent agent_;
  std::vector<std::string> touched_, restated_;  // since the last reading
  std::vector<Bounds> bounds_;
  void note(const EdgeChange& edges);

  NodeLinks links_read_;
  std::set<Edge> added_, removed_;  // since the home
  std::set<std::string> ever_touched_;
};

}  // namespace unietp
