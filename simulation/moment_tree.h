#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "simulation/moment_id.h"
#include "simulation/view.h"
#include "simulation/world_state.h"

namespace unietp {

/// All that has happened from one start, in every branch that was tried: a tree of moments, of which one is laid out as
/// a WorldState. Moments that are alike in all that can change are one moment, however they were reached, and a step
/// that was done once is not done again: mutants of a plan are mostly the plan itself.
class MomentTree {
 public:
  MomentTree(WorldState start, Viewer viewer);

  struct Step {
    ActionResult result;
    Delta changes;
    MomentId next;
  };
  /// What the action comes to at that moment. The reference stays valid.
  const Step& step(MomentId at, const Action& action);
  /// The state at that moment, until another one is asked for.
  const WorldState& at(MomentId moment);
  bool stopped(MomentId moment) const { return moments_[moment.index()].stopped; }
  const Profile& profile() const { return *state_.profile; }
  const std::vector<VisibleObject>& visible(MomentId moment, double sight_m);
  /// Whether the view within the profile's sight has the object.
  bool shows(MomentId moment, std::string_view id);
  /// A workplace for looking at the state that is laid out.
  Viewer& viewer() { return viewer_; }

 private:
  struct Moment {
    MomentId parent;
    std::uint32_t depth = 0;
    std::vector<Edit> log;  // between the parent and here
    Digest digest;
    bool stopped = false;
    std::unordered_map<std::string, Step> steps;                     // by the action's text
    std::unordered_map<double, std::vector<VisibleObject>> visible;  // by how far the agent sees
    std::unordered_map<std::string, bool> shown;                     // by id, as far as asked for
  };
  void go(MomentId to);

  WorldState state_;
  MomentId here_;
  std::deque<Moment> moments_;
  std::unordered_map<Digest, MomentId, DigestHash> known_;
  Viewer viewer_;
};

}  // namespace unietp
