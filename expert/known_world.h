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

/// The home as an agent knows it at the start (Window::known_scene), in physics. What the agent is about to do to look
/// around is tried here first, so that it wastes no step. It is built when it is first needed, and does what the agent
/// does from then on. Where it cannot be built, everything is taken to work.
class KnownWorld {
 public:
  /// All must outlive it.
  KnownWorld(const Knowledge& knowledge, const Profile& profile, const Window& window)
      : knowledge_(knowledge), profile_(profile), window_(window) {}

  /// What is computed once of the home that is known from the start.
  KnownHome& home();
  /// The agent did this.
  void follow(const Action& action);
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
  /// nullptr where it cannot be built.
  const World* world();

  const Knowledge& knowledge_;
  const Profile& profile_;
  const Window& window_;
  std::unique_ptr<KnownHome> home_;
  std::unique_ptr<World> world_;
};

}  // namespace unietp
