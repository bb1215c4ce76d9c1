#include "scores/judged_episode.h"

#include <nlohmann/json.hpp>

namespace unietp {
namespace {

/// The stored demonstration in a mode, if there is one.
std::optional<DemonstrationRecord> expert_way(const TaskSource& tasks, const EpisodeKey& key) {
  const auto position = tasks.find(key.task);
  if (!position) return std::nullopt;
  auto shown = tasks.demonstration(*position, key.mode);
  return shown ? std::optional(std::move(*shown)) : std::nullopt;
}

}  // namespace

JudgedEpisode judge_episode(const EpisodeRecord& record, const ReplayedEpisode& replayed, const EnvironmentTask& task,
                            const JudgingData& data, const EpisodePictures& pictures) {
  const auto expert = expert_way(data.tasks, record.key);
  return {score_episode(record, replayed, task, data.held_out.contains(task.text.template_name)),
          episode_view(record, replayed, task, expert ? &*expert : nullptr, pictures)
              .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)};
}

}  // namespace unietp
