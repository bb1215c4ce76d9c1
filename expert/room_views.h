#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "scene/scene.h"
#include "simulation/profile.h"

namespace unietp {

/// What of each room an agent has looked at: which of some points spread over its floor were between the left and the
/// right edge of the picture while it stood in the room. Furniture hides nothing. Deterministic.
class RoomViews {
 public:
  /// `home`: its rooms. `profile`: of the camera, and by how much a step turns the agent.
  RoomViews(const Scene& home, const Profile& profile);

  /// The agent was there.
  void saw(const Agent& body);
  /// Going to a room led there: to its middle, or beside what stands in it.
  void arrived(std::size_t room, const Vec2& position) { rooms_[room].middle = position; }
  /// The share of a room, by its position in the scene, that was not looked at; from 0 to 1.
  double unseen(std::size_t room) const;

  /// A view of a room: from where the agent stands, or from where going to the room leads, which is taken to be its
  /// middle until the agent has arrived there; then some turns to the left, or to the right where they are negative.
  struct Look {
    bool goes = false;
    int turns = 0;
    double shows = 0;  // the share of the room that was not looked at before
    int steps() const { return (goes ? 1 : 0) + (turns < 0 ? -turns : turns); }
  };
  /// The one that shows most for its steps; nullopt when none shows more.
  std::optional<Look> best(std::size_t room, const Agent& body) const;

 private:
  struct Seen {
    const Room* room = nullptr;
    Vec2 middle = Vec2::Zero();  // or where going there led
    std::vector<Vec2> unseen;
    std::size_t all = 0;
  };
  /// Whether a view along a unit vector shows what lies `way` from there.
  bool shows(const Vec2& ahead, const Vec2& way, double away) const;

  std::vector<Seen> rooms_;
  double narrowest_ = 0;  // cosine between the middle of the picture and what is at its edge
  double turn_ = 0;       // radians
};

}  // namespace unietp
