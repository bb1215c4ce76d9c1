#pragma once

#include <memory>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "expert/known_home.h"
#include "expert/search_order.h"
#include "expert/window.h"
#include "simulation/profile.h"
#include "simulation/world.h"

namespace unietp {

/// How far from where a step should have led an agent has strayed.
inline constexpr double kStray_m = 0.01;

/// The home as an agent knows it, in physics: what it knows at the start (Window::known_scene), and from the last
/// `believe` on what it believed then. What the agent is about to do is tried here first, so that it wastes no step. It
/// is built when it is first needed, and does what the agent does from then on. Where it cannot be built, everything is
/// taken to work.
class KnownWorld {
 public:
  /// All must outlive it.
  KnownWorld(const Knowledge& knowledge, const Profile& profile, const Window& window)
      : knowledge_(knowledge), profile_(profile), window_(window) {}
  /// This is what the home is like. It must outlive this and may change as what the agent does is foreseen here;
  /// whatever else changes is to be told again.
  void believe(const Scene& believed);

  /// What is computed once of the home that is known from the start.
  KnownHome& home();
  /// Whether the agent is there, as far as it was built.
  bool is_at(const Agent& body) const { return !world_ || world_->agent() == body; }
  /// The agent did this.
  void follow(const Action& action);
  /// Now; nullptr where it cannot be built. Valid until the next call of any of these.
  World* world();
  /// Whether the agent could do it now.
  bool allows(const Action& action);
  /// What keeps the agent from looking at a place.
  enum class Obstacle {
    None,
    NoWay,   // it cannot go there
    Shut,    // it cannot open it
    NoView,  // the camera cannot be turned so
  };
  /// `way`: the steps to the look when nothing is opened.
  Obstacle obstacle_to(const SearchOrder::Look& look, const std::vector<Action>& way);
  /// Whether it can be opened from where the agent stands, and is in the picture.
  bool opens_from_here(const std::string& id);

 private:
  const Knowledge& knowledge_;
  const Profile& profile_;
  const Window& window_;
  const Scene* believed_ = nullptr;
  std::unique_ptr<KnownHome> home_;
  std::unique_ptr<World> world_;
};

}  // namespace unietp
