#pragma once

#include <string>
#include <vector>

#include "environment/environment.h"
#include "evaluation/episode_record.h"
#include "scores/replayed_episode.h"

namespace unietp::testing {

/// An episode as a runner would record it: what an agent said, and what came of it.
struct PlayedEpisode {
  EpisodeRecord record;
  ReplayedEpisode replayed;
};
/// Plays the replies until the episode is over. `errored`: and then no further reply could be had.
PlayedEpisode played(const SharedTask& task, const Settings& settings, const std::vector<std::string>& replies,
                     bool errored = false);

}  // namespace unietp::testing
