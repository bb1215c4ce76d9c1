#pragma once

#include <vector>

#include "expert/rollout.h"
#include "scene/scene.h"
#include "simulation/outcome.h"

namespace unietp {

/// All that an agent of M2 learns of a home, and all that it can do there. Who plans behind a window has no other way
/// to the world, so what it does depends only on what it knew at the start and what it has seen.
class Window {
 public:
  virtual ~Window() = default;
  /// What the mode shows at the start: rooms, their openings, and furniture by id, category, place and size, in the
  /// states that such furniture has by default, whatever its states are. Nothing movable; no relations.
  virtual const Scene& known_scene() const = 0;
  /// The objects in view and in the hand, each as it looks now. Sorted by id, those in the hand last.
  virtual std::vector<Node> view() const = 0;
  /// Where the agent stands, where it looks, and what it holds.
  virtual const Agent& body() const = 0;
  /// Does an action under the rules of M2. What cannot be named now fails without being done.
  virtual Outcome act(const Action& action) = 0;
};

/// The window of an agent in an episode that begins at the start of an execution tree.
class EpisodeWindow : public Window {
 public:
  /// The tree must outlive it.
  explicit EpisodeWindow(ExecutionTree& executions);

  const Scene& known_scene() const override { return known_scene_; }
  std::vector<Node> view() const override;
  const Agent& body() const override { return rollout_.episode().world().agent(); }
  Outcome act(const Action& action) override { return rollout_.go_on(action); }
  /// The actions that succeeded, and whether they reach the goal; for who judges, not for who plans.
  const std::vector<Action>& done() const { return rollout_.done(); }
  bool reaches_goal() const { return rollout_.reaches_goal(); }

 private:
  Rollout rollout_;
  Scene known_scene_;
};

}  // namespace unietp
