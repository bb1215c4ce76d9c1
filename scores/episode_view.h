#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "environment/task.h"
#include "evaluation/episode_record.h"
#include "record/task_record.h"
#include "scores/replayed_episode.h"

namespace unietp {

/// The pictures of an episode, before each reply and after the last; PNG files, or none.
using EpisodePictures = std::vector<std::string>;
/// What the agent saw, at most `width` pixels wide. "" when it cannot be made.
std::string view_picture(const Environment& environment, int width);

/// An episode as the report's viewer plays it (assets/evaluation.js), without its score: what is known of its task,
/// each reply with what was seen, said, done and told, which parts of the goal were met after each action, and the
/// expert's way in the same mode (`expert`; may be empty). Long texts are cut.
nlohmann::ordered_json episode_view(const EpisodeRecord& record, const ReplayedEpisode& replayed,
                                    const EnvironmentTask& task, const std::vector<Command>& expert,
                                    const EpisodePictures& pictures);

}  // namespace unietp
