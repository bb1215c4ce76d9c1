#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/rng.h"
#include "grounding/failure.h"
#include "grounding/goal_places.h"
#include "grounding/workspace.h"
#include "logic/vocabulary.h"
#include "simulation/profile.h"

namespace unietp {

/// Single edits of a scene that keep it physical: each moves, adds, removes or changes one object and settles only
/// that. An edit that fails says why (`failure`). Objects are named by id, since positions shift when one is taken out.
/// Deterministic: draws come from a stream forked per edit.
class SceneEditor {
 public:
  SceneEditor(Workspace& workspace, GoalPlaces avoid, const Profile& profile, int draws, Rng rng);

  /// A new object of the category where the knowledge puts it, on or in a receptacle that `accept` likes, away from the
  /// goal's places. Its id, or nullopt.
  std::optional<std::string> add_object(
      const std::string& category,
      const std::function<bool(const Node& receptacle)>& accept = [](const Node&) { return true; });
  /// A new piece of furniture in the given room. Whether it shuts off another room is not looked at.
  std::optional<std::string> add_furniture(const std::string& category, std::size_t room);
  /// Whether every room can still be walked to.
  bool leaves_rooms_open();
  /// Takes an object out; what rests on or in it is moved first. Not furniture of the home.
  bool remove(const std::string& id);
  /// Sets an object as it once was, which may have been taken out since. Whether it has room is not looked at.
  void replace(Node node);

  bool put(const std::string& id, Predicate relation, const std::string& receptacle);  // on, inside, next_to, under
  bool put_on_floor(const std::string& id, const std::string& room);
  /// Elsewhere: on or in a receptacle that `accept` likes; away from the goal's places where there is a choice.
  bool relocate(const std::string& id, const std::function<bool(const Node& receptacle)>& accept);

  /// To a place that is clearly nearer to `other` than every thing of its category (clearly_nearer of
  /// scene/size_and_nearness.h).
  bool bring_near(const std::string& id, const std::string& other);

  /// Sets a state of an exclusive group, `covered`, color, material or size; doors and lids move with `open` and
  /// `closed`; what becomes larger or smaller is put back where it was.
  bool set_state(const std::string& id, Predicate predicate, const std::string& symbol, bool truth);
  bool move_agent(const std::string& room, bool into);

  /// Objects that other edits must not use up or throw away.
  std::set<std::string>& reserved() { return reserved_; }
  const std::set<std::string>& touched() const { return touched_; }
  const GroundingFailure& failure() const { return failure_; }
  Workspace& workspace() { return workspace_; }
  /// Reads the edges anew when something changed since the last time.
  void refresh();

  /// Notes why something failed and gives false.
  bool fail(RejectionReason reason, std::string detail);

 private:
  std::optional<std::size_t> index_of(const std::string& id) const;
  Rng next_rng();
  bool clear_off(const std::string& id);
  /// What comes into a fridge or a freezer is cold as all that is there; what comes out of one is not any more.
  void temper(Node& node, Predicate relation, const Node& receptacle) const;
  bool move_to(const std::string& id, const Pose& pose);
  bool open_or_close(const std::string& id, double opening);
  bool give_box(const std::string& id, const Vec3& size, const std::string& asset);
  bool resize(const std::string& id, const std::string& size, bool truth);
  bool place_near(const std::string& id, const std::string& other);
  bool place_under(const std::string& id, const std::string& other);
  bool settle_somewhere(Node node, const std::function<bool(const Node&)>& accept);

  Workspace& workspace_;
  GoalPlaces avoid_;
  const Profile& profile_;
  int draws_;
  Rng rng_;
  std::uint64_t edit_number_ = 0;
  bool stale_ = false;
  std::set<std::string> reserved_, touched_;
  std::set<std::string> clearing_;  // what is being taken off things now
  GroundingFailure failure_;
};

}  // namespace unietp
