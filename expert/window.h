#pragma once

#include <map>
#include <string>
#include <vector>

#include "expert/rollout.h"
#include "scene/node_index.h"
#include "scene/scene.h"
#include "simulation/outcome.h"

namespace unietp {

/// All that an agent of M2 or M3 learns of a home, and all that it can do there. Who plans behind a window has no other
/// way to the world, so what it does depends only on what it knew at the start and what it has seen.
class Window {
 public:
  virtual ~Window() = default;
  /// What the mode shows at the start: rooms and their openings; in M2 also furniture by id, category, place and size,
  /// in the states that such furniture has by default, whatever its states are. Nothing movable; no relations.
  virtual const Scene& known_scene() const = 0;
  /// What the agent sees, each thing as it looks now: in M2 the objects in view, in M3 all that it can point at in the
  /// picture; and what is in the hand, which comes last.
  virtual std::vector<Node> view() const = 0;
  /// Where the agent stands, where it looks, and what it holds.
  virtual const Agent& body() const = 0;
  /// Does an action under the rules of the mode. What cannot be named or pointed at now fails without being done.
  virtual Outcome act(const Action& action) = 0;
};

/// The window of an agent of M2 or M3 in an episode that begins at the start of an execution tree. In M3, where no
/// object has an id, it keeps track of things as a person does who sees the same mug again: a thing is called by a name
/// of its own from when it is first seen, "mug_2" for the second mug. Names are given in the order in which things come
/// into the picture, those of one picture from left to right, and say no more than that.
class EpisodeWindow : public Window {
 public:
  /// The tree must outlive it.
  EpisodeWindow(ExecutionTree& executions, Mode mode);

  const Scene& known_scene() const override { return known_scene_; }
  std::vector<Node> view() const override { return view_; }
  const Agent& body() const override { return body_; }
  Outcome act(const Action& action) override;
  /// The actions that succeeded, on the ids of the home, and whether they reach the goal; for who judges, not for who
  /// plans.
  const std::vector<Action>& done() const { return rollout_.done(); }
  bool reaches_goal() const { return rollout_.reaches_goal(); }

 private:
  bool points() const { return rollout_.episode().rules().atomic == Naming::Box; }
  void look();
  std::vector<std::string> in_the_hand() const;
  /// The ids of what can be pointed at.
  std::vector<std::string> pictured() const;
  void give_name(const Node& node);
  /// With what it refers to by the names that were given.
  Node renamed(Node node) const;

  Rollout rollout_;
  Scene known_scene_;
  std::vector<Node> view_;
  Agent body_;
  // M3: names by id and back, and what they were given to.
  std::map<std::string, std::string, std::less<>> names_, ids_;
  Scene named_;
  NodeIndex named_places_;
};

}  // namespace unietp
