#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "akb/knowledge.h"
#include "expert/rollout.h"
#include "scene/scene.h"
#include "simulation/outcome.h"

namespace unietp {

/// All that an agent of M2 or M3 learns of a home, and all that it can do there. Who plans behind a window has no other
/// way to the world, so what it does depends only on what it knew at the start and what it has seen.
class Window {
 public:
  virtual ~Window() = default;
  /// What the mode shows at the start: rooms and their openings; in M2 also furniture by id, category, place and size,
  /// in the states that such furniture has by default, whatever its states are, and of no color or material. Nothing
  /// movable; no relations.
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
/// object has an id, each thing in view is called by its box in the picture ("12 40 80 99"), from left to right, and
/// what is in the hand, which has none, "in hand 1" and so on. Such names hold for one view. Of a thing it shows what
/// the picture does, its distance included: category, states, color, material, place and shape; what it weighs is
/// guessed from that, and neither its model nor what it was cut from is told.
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
  /// M3: the ids of what the present names stand for; for who judges, too.
  const std::map<std::string, std::string, std::less<>>& meant() const { return meant_; }

 private:
  bool points() const { return rollout_.episode().rules().atomic == Naming::Box; }
  void look();
  std::vector<std::string> in_the_hand() const;
  void show(const std::string& id, std::string name);

  Rollout rollout_;
  const Knowledge& knowledge_;
  Scene known_scene_;
  std::vector<Node> view_;
  Agent body_;
  std::map<std::string, std::string, std::less<>> meant_;
};

/// Whether a name of M3 is one of what is in the hand.
bool is_in_hand(std::string_view name);

}  // namespace unietp
