#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/result.h"
#include "evaluation/evaluation_manifest.h"
#include "scores/watched_episodes.h"

namespace unietp {

/// How long the replies of a mode took, of all that were not taken from a log or a cache; seconds.
struct LatencyFigures {
  int replies = 0;
  double mean = 0, median = 0, percentile_95 = 0, total = 0;
  bool operator==(const LatencyFigures&) const = default;
};

/// A finished or interrupted evaluation with its scores: all that tables are made of.
struct ScoredRun {
  std::string name;  // of the folder, for people
  EvaluationManifest manifest;
  std::vector<EpisodeScore> scores;        // in the order of the episodes
  std::map<Mode, LatencyFigures> latency;  // of the modes that have a reply with a time
  bool operator==(const ScoredRun&) const = default;

  /// Episodes that are not in the log yet.
  int missing() const;
  /// None is missing or errored.
  bool complete() const;
};

/// What scoring needs beside the folder of an evaluation.
struct ScoringData {
  const JudgingData& judging;
  int threads = 1;
  const WatchedEpisodes* watched = nullptr;  // these episodes are not executed again
};

/// An episode that does not agree with what its replies lead to.
struct ScoringDifference {
  int line = 0;  // of episodes.jsonl
  EpisodeKey key;
  EpisodeDifference difference;
};

/// What to make of the episodes beside their scores.
struct ScoringCallbacks {
  std::function<void(const ScoringDifference&)> differ;  // hears of each disagreement
  std::function<Result<Done>(std::string&& view)> view;  // takes each episode_view as JSON
  int picture_width = 0;  // pixels; 0: no view has pictures, not even of the episodes that the manifest allows
};

/// Executes the episodes of a folder again and scores them. `watch` is called in the order of the file; the scores are
/// those of the replies. Deterministic for any number of threads, and for any that were watched. Errors: Io, Parse and
/// Schema of the files; Usage for a task that the data set lacks; those of `watch`.
Result<ScoredRun> score_run(const std::filesystem::path& folder, const ScoringData& data,
                            const ScoringCallbacks& watch);

/// Reads the scores that a run's folder has, and compares them with its episodes as they are recorded; nothing is
/// executed again. Errors: Io, Parse; Schema, also for scores that are not those of the episodes and for episodes that
/// are not those of the manifest; Usage for a folder without them.
Result<ScoredRun> read_scored_run(const std::filesystem::path& folder);

/// All lines of episodes.jsonl, one after the other. Errors: Io, Parse, Schema; those of `take`.
Result<Done> for_each_episode(const std::filesystem::path& folder,
                              const std::function<Result<Done>(int line, EpisodeRecord&& episode)>& take);

}  // namespace unietp
