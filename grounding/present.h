#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grounding/home.h"
#include "scene/trace.h"

namespace unietp {

/// What physics and the logic show of a scene that grew out of a home, kept up to date at the cost of what changed
/// since it was last read; without comparisons (`nearest`, `size`).
class Present {
 public:
  /// Of the home as it is.
  explicit Present(const Home& home);

  /// A node came, went or changed; `bounds`: of its body before, or now.
  void touch(const std::string& id, const Bounds& bounds);
  /// Reads what can have changed. `edges` are those of the last reading, at first the home's; they become those that
  /// physics shows of the scene now. The scene's own are not looked at.
  void read(const Scene& scene, const PhysicsWorld& physics, std::vector<Edge>& edges);

  /// The state that was read last. Entities that are gone stay in the list and do not exist.
  const Trace& now() const { return trace_; }
  const FactReader& reader() const { return reader_; }  // that read it

 private:
  FactReader reader_;
  Trace trace_;
  Agent agent_;
  std::vector<std::string> touched_;  // since the last reading
  std::vector<Bounds> bounds_;
};

/// A scene that grew out of a home, compared with it and read at the cost of the differences.
struct GrownScene {
  std::vector<Edge> edges;  // as read_relations gives them
  Trace now;
};
GrownScene read_grown(const Home& home, const Scene& scene, const PhysicsWorld& physics);

}  // namespace unietp
