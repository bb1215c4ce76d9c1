#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/result.h"
#include "environment/task_source.h"
#include "evaluation/episode_log.h"
#include "evaluation/episode_watcher.h"
#include "evaluation/evaluation_manifest.h"
#include "evaluation/policy.h"
#include "evaluation/simulator_program.h"

namespace unietp {

/// The episodes of a selection: the tasks in the order of the data set, each in every mode, each repeat after the
/// other.
struct EpisodePlan {
  std::vector<PlannedEpisode> episodes;
  int without_demonstration = 0;  // tasks and modes left out, since they have none
};
/// `demonstrated`: only with tasks that have a demonstration in the mode. Errors: Usage, for a split, simulator or task
/// that the data set does not have, and when nothing is left.
Result<EpisodePlan> plan_episodes(const TaskSource& tasks, const EpisodeSelection& selection, bool demonstrated);

/// How it goes, while it runs.
struct EvaluationProgress {
  int episodes = 0, finished = 0, errored = 0, succeeded = 0;  // of the plan, those of earlier runs included
  int finished_now = 0;                                        // in this run
  double cost = 0, seconds = 0;                                // of all; of this run
};

/// How an evaluation is run.
struct EvaluationOptions {
  int at_once = 1;          // episodes played at a time, each on a thread of its own
  int policy_attempts = 3;  // of an episode whose policy's program failed
  double first_wait_s = 1;  // before the second of them; doubled each time
  const std::atomic<bool>* stop = nullptr;
  std::function<void(const EvaluationProgress&)> progress;  // called by one thread at a time
  WatcherMaker watcher;
  SimulatorMaker simulator = {};  // in which the episodes are acted out, too; empty: our physics alone
};

/// How a run ended.
struct EvaluationReport {
  EvaluationProgress progress;
  bool interrupted = false;
  std::string given_up;  // why no further episode was begun; "" otherwise
};

/// Plays the episodes of the plan that the log does not have, and those that errored. Which thread plays which, and in
/// what order they end, changes nothing that is recorded. Errors: Io, of the log; those of a task that cannot be read.
Result<EvaluationReport> evaluate(const EpisodePlan& plan, const TaskSource& tasks,
                                  const std::map<Mode, Settings>& settings, const PolicyMaker& policy, EpisodeLog& log,
                                  const EvaluationOptions& options);

/// Writes episodes.jsonl and timing.jsonl in the order of the plan, from the log, and manifest.json. Equal episodes
/// give equal bytes of episodes.jsonl. `report_pictures`: as in the manifest. Errors: Io.
Result<EvaluationManifest> write_evaluation(const std::filesystem::path& folder, const EvaluationSetup& setup,
                                            const EpisodePlan& plan, const EpisodeLog& log,
                                            int report_pictures = kReportPictures);

}  // namespace unietp
