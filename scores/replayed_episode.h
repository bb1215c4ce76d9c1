#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "environment/environment.h"
#include "evaluation/episode_record.h"
#include "scene/visible_object.h"
#include "scores/scored_parts.h"

namespace unietp {

/// An action of an episode as it went when it was done again.
struct ReplayedAction {
  EpisodeAction record;
  std::string object;             // id of what it named, also by a box; "" when it named nothing that is there
  std::optional<double> overlap;  // of its box and the best matching one in the picture; nullopt: named by no box
  double progress = 0;            // afterwards
  bool reached = false;           // the goal would hold if the episode ended here
  std::vector<bool> parts;        // of the goal: which are met if it ended here
};

/// A reply of an episode, with what was in the picture before it.
struct ReplayedStep {
  std::vector<VisibleObject> pictured;  // sorted by id; empty where views are not kept
  std::string unreadable;               // what was expected of a reply that could not be read
  std::vector<ReplayedAction> actions;
  std::string observation;  // the observation afterwards, in words
};

/// All that follows from the replies of an episode, its task and its settings.
struct ReplayedEpisode {
  EpisodeOutcome end = EpisodeOutcome::Errored;  // Errored: it is not over after the last reply
  bool success = false;
  double start_progress = 0, progress = 0;
  int counted = 0, failures = 0;
  std::vector<ScoredPart> parts;
  std::vector<bool> parts_at_start;  // which are met at the start
  std::vector<bool> parts_lost;      // of those not met at the end: which order or constraint was lost
  std::vector<ReplayedStep> steps;   // fewer than the record's where the episode was over before
  bool targets_shown = false;        // of all goal_objects one that is meant was in a picture, the last included
  std::string first_observation;     // the observation at the start, in words
};

/// Gathers all this while the replies are executed, by a run or again: for each reply `begin_reply`, for each of its
/// actions `look` and `acted`, then `end_reply`. Views are what costs most, so they are made only where something is
/// named by its place in the picture, and for each reply with `keeps_views`.
class EpisodeFollower {
 public:
  explicit EpisodeFollower(const Environment& start, bool keeps_views = false);
  EpisodeFollower(EpisodeFollower&&) noexcept;
  EpisodeFollower& operator=(EpisodeFollower&&) noexcept;
  ~EpisodeFollower();

  /// Before the first action of a reply.
  void begin_reply(const Environment& now);
  /// Before each action; not needed before what could not be read.
  void look(const AnsweredAction& next, const Environment& now);
  /// After one, or after what could not be read. `result` has at most one action.
  void acted(const StepResult& result, const Environment& now);
  void end_reply(const std::string& unreadable, const Environment& now);
  ReplayedEpisode finish(const Environment& last) &&;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Called before each reply, and once after the last, with the environment as it is then; for pictures.
using WatchEpisode = std::function<void(std::size_t step, const Environment& environment)>;

/// Does an episode again from its replies, and from what the simulator said where it was acted out in one.
/// Deterministic. Errors: those of Environment::make.
Result<ReplayedEpisode> replay_episode(const EpisodeRecord& record, const SharedTask& task, const Settings& settings,
                                       const WatchEpisode& watch = {});

/// Where a record differs from what its replies lead to: the field as a JSON pointer in the line, and both values.
/// Fields that replies do not determine (prompt, tokens, models, …) are not compared. Empty when they agree.
struct EpisodeDifference {
  std::string pointer, recorded, replayed;
};
std::vector<EpisodeDifference> differences(const EpisodeRecord& record, const ReplayedEpisode& replayed,
                                           const EnvironmentTask& task);

}  // namespace unietp
