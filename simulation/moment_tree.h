#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "simulation/passed_moment.h"
#include "simulation/view.h"
#include "simulation/world_state.h"

namespace unietp {

/// All states reached from one start, in every branch that was tried: a tree of moments, one of which is the current
/// WorldState. Equal states are one moment, however they were reached, and the result of each step is remembered, since
/// the mutants of a plan mostly repeat the plan.
class MomentTree {
 public:
  MomentTree(WorldState start, Viewer viewer);

  struct Step {
    ActionResult result;
    Delta changes;
    MomentId next;
    std::vector<PassedMoment> passed;  // `next` last; empty when nothing lies between
  };
  /// The result of the action at that moment. The reference stays valid.
  const Step& step(MomentId at, const Action& action);
  /// The state at that moment; valid until another moment is asked for.
  const WorldState& at(MomentId moment);
  /// Makes one moment the first and only one. All references and the ids of other moments are void.
  void forget_all_but(MomentId moment);
  bool stopped(MomentId moment) const { return moments_[moment.index()].stopped; }
  const Profile& profile() const { return *state_.profile; }
  const std::vector<VisibleObject>& visible(MomentId moment, double sight_m);
  /// Whether the object is visible within the profile's limit of sight.
  bool shows(MomentId moment, std::string_view id);
  /// Where several objects in the picture have the same box, without a limit of sight, the box stands for the one with
  /// the smallest id. `unique_box`: the box that stands for an object; nullopt where there is none. `object_of_box`:
  /// the object that a box stands for, of those whose `unique_box` was asked for; nullptr where there is none.
  const std::optional<PixelBox>& unique_box(MomentId moment, std::string_view id);
  const std::string* object_of_box(MomentId moment, const PixelBox& box) const;
  /// Renders views of the current state.
  Viewer& viewer() { return viewer_; }

 private:
  struct Moment {
    MomentId parent;
    std::uint32_t depth = 0;
    std::vector<Edit> log;  // from the parent to this moment
    Digest digest;
    bool stopped = false;
    std::unordered_map<std::string, Step> steps;                        // by the action's text
    std::unordered_map<double, std::vector<VisibleObject>> visible;     // by limit of sight, meters
    std::unordered_map<std::string, bool> shown;                        // by id; only those that were asked for
    std::map<std::string, std::optional<PixelBox>, std::less<>> boxes;  // by the id that they mean; likewise
  };
  /// A part of a step: where its edits end in the log, and what they change.
  struct Part {
    std::size_t end = 0;
    WorldState::Change change;
  };
  void go(MomentId to);
  /// The moment after edits that were done in another one, which a new one takes over.
  std::pair<MomentId, bool> enter(MomentId from, const Digest& difference, std::vector<Edit>& log, bool stopped);
  /// Enters the moments of a step of several parts, whose edits are all undone.
  std::vector<PassedMoment> enter_all(MomentId from, std::vector<Part> parts, std::vector<Edit> log);

  WorldState state_;
  MomentId here_;
  std::deque<Moment> moments_;
  std::unordered_map<Digest, MomentId, DigestHash> known_;
  Viewer viewer_;
};

}  // namespace unietp
