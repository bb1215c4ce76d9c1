#include "scores/judged_episode.h"

#include <nlohmann/json.hpp>

namespace unietp {
namespace {

/// What the stored demonstration in the mode does; empty where there is none.
std::vector<Command> expert_way(const TaskSource& tasks, const EpisodeKey& key) {
  const auto position = tasks.find(key.task);
  if (!position) return {};
  auto plan = tasks.demonstrated_plan(*position, key.mode);
  return plan ? std::move(*plan) : std::vector<Command>();
}

}  // namespace

JudgedEpisode judge_episode(const EpisodeRecord& record, const ReplayedEpisode& replayed, const EnvironmentTask& task,
                            const JudgingData& data, const EpisodePictures& pictures) {
  return {score_episode(record, replayed, task, data.held_out.contains(task.text.template_name)),
          episode_view(record, replayed, task, expert_way(data.tasks, record.key), pictures)
              .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)};
}

}  // namespace unietp
