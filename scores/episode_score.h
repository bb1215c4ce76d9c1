#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "environment/task.h"
#include "evaluation/episode_record.h"
#include "scores/replayed_episode.h"

namespace unietp {

/// The file in an evaluation's folder with one of these a line, in the order of its episodes.
inline constexpr const char* kScoresFile = "scores.jsonl";

/// What one episode amounts to: a line of scores.jsonl. Follows from the episode, its task, and what is known of plans.
struct EpisodeScore {
  EpisodeKey key;
  std::string simulator, split, template_name, layout;  // the layout names the home
  bool held_out = false;                                // its template is one of the third that training can leave out
  EpisodeOutcome end = EpisodeOutcome::Stop;
  bool success = false;  // the goal is true at the end
  double progress = 0;   // 0 to 1, at the end
  int steps = 0, failures = 0;
  int replies = 0, actions = 0;
  int no_json = 0, truncated = 0, unknown_action = 0, bad_argument = 0;  // actions that are faults of output
  bool premature_stop = false, missed_stop = false;
  int boxes = 0, hits = 0;      // actions that named a thing by a box; those that met one
  double overlap = 0;           // intersection over union, summed over the hits
  std::optional<int> shortest;  // steps of the shortest known plan: the demonstration's, or a success of this run
  std::int64_t prompt_tokens = 0, completion_tokens = 0;
  double cost = 0;
  std::vector<std::string> classes;  // all that fit, the first is its class: "output: truncated"; empty: a success
  bool operator==(const EpisodeScore&) const = default;

  bool errored() const { return end == EpisodeOutcome::Errored; }  // has no result of the policy's
};

/// The part of an episode's score that does not depend on the other episodes of its run. They determine the shortest
/// known plan, and with it whether the agent stopped too early.
struct PartialScore {
  EpisodeScore score;          // its shortest is the data set's; premature_stop and the class of it are still missing
  int successful_actions = 0;  // `stop` among them
  bool operator==(const PartialScore&) const = default;
};
/// `held_out` as above.
PartialScore score_episode(const EpisodeRecord& record, const ReplayedEpisode& replayed, const EnvironmentTask& task,
                           bool held_out);
/// Completes a partial score. `fewest`: steps of the shortest success of its run at the task in its mode, if there is
/// one.
EpisodeScore finalize_score(PartialScore partial, std::optional<int> fewest);

/// A line without its line feed. Equal scores give equal bytes.
std::string score_line(const EpisodeScore& score);
/// Errors: Parse with line and column; Schema with a JSON pointer for a missing, unknown or mistyped field, and for
/// fields that contradict each other.
Result<EpisodeScore> read_score(std::string_view where, int line, std::string_view text);

}  // namespace unietp
