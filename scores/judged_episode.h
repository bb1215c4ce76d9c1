#pragma once

#include <set>
#include <string>

#include "environment/task_source.h"
#include "scores/episode_score.h"
#include "scores/episode_view.h"

namespace unietp {

/// What judging an episode needs beside it.
struct JudgingData {
  const TaskSource& tasks;                      // of the data set that the run was made on
  std::set<std::string, std::less<>> held_out;  // templates that training can leave out
};

/// What an episode amounts to by itself.
struct JudgedEpisode {
  PartialScore score;
  std::string view;  // episode_view as JSON in one line
};

/// `replayed` belongs to the record. Thread-safe.
JudgedEpisode judge_episode(const EpisodeRecord& record, const ReplayedEpisode& replayed, const EnvironmentTask& task,
                            const JudgingData& data, const EpisodePictures& pictures);

}  // namespace unietp
