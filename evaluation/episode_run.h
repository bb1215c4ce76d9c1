#pragma once

#include <string>
#include <variant>

#include "environment/environment.h"
#include "evaluation/episode_watcher.h"
#include "evaluation/policy.h"

namespace unietp {

/// An episode as it was played.
struct PlayedEpisode {
  EpisodeRecord record;
  TimingRecord timing;
};

/// Plays one episode in an environment at its start, until it ends or there is no reply. What the agent said goes to
/// the environment as UTF-8 of at most `reply_bytes`, and is recorded so; what could not be read is a failed step like
/// any other. Gives NoReply where the episode is to be left as if it had not begun: when the run is stopped or given
/// up, and when it may be begun again. `watcher`, which may be null, looks on; its `end` is left to the caller.
/// Deterministic as far as the policy is.
std::variant<PlayedEpisode, NoReply> play_episode(const PlannedEpisode& planned, Environment& environment,
                                                  Policy& policy, EpisodeWatcher* watcher = nullptr);

/// The record of an episode that never got a first reply. `environment` is at its start.
PlayedEpisode unplayed(const PlannedEpisode& planned, const Environment& environment, const NoReply& none);

/// The most bytes of a reply under these settings.
std::size_t reply_bytes(const Settings& settings);
/// The text with each byte that is no UTF-8 replaced by U+FFFD, and cut at `most` bytes, between characters.
std::string kept_text(const std::string& text, std::size_t most);

}  // namespace unietp
