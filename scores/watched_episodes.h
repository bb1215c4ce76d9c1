#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include "core/file_place.h"
#include "evaluation/episode_watcher.h"
#include "scores/judged_episode.h"

namespace unietp {

/// Judges episodes while they are played, so that the results of a run need not execute them again. An episode with a
/// reply of several actions is left out: what each of them came to is not to be seen from outside. What is kept lies in
/// a file without a name, so memory does not grow with it and nothing of it stays. Thread-safe.
class WatchedEpisodes {
 public:
  /// `folder`: on whose disk the file lies. `data` must outlive it. Errors: Io.
  static Result<WatchedEpisodes> begin(const std::filesystem::path& folder, const JudgingData& data);

  /// Watches each episode while it is played.
  WatcherMaker watchers();
  /// The episode, as judge_episode gives it without pictures; nullopt when it was not watched. Errors: Io.
  Result<std::optional<JudgedEpisode>> find(const EpisodeKey& key) const;

 private:
  class Watcher;
  struct Place {
    std::uint64_t at = 0;
    std::size_t score_bytes = 0, view_bytes = 0;
    int successful_actions = 0;
  };
  struct State {
    Descriptor file;
    std::filesystem::path folder;
    std::mutex mutex;  // of what follows
    std::map<EpisodeKey, Place> places;
    std::uint64_t bytes = 0;
  };
  WatchedEpisodes(std::shared_ptr<State> state, const JudgingData& data) : state_(std::move(state)), data_(&data) {}

  std::shared_ptr<State> state_;  // shared with the watchers
  const JudgingData* data_;
};

}  // namespace unietp
