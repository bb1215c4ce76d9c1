#include "python/native/episode_tasks.h"

#include "core/limits.h"
#include "core/rng.h"

namespace unietp::python {
namespace {

Result<SharedTask> task_from(const TaskSource& source, std::optional<std::uint64_t> seed, std::uint64_t episode) {
  if (source.size() == 0) return Error{Error::Kind::Usage, "tasks.jsonl", {}, "has no tasks"};
  const auto pass = episode / source.size();
  const auto position = static_cast<std::size_t>(episode % source.size());
  return source.task(seed ? source.order(*seed + pass).at(position) : position);
}

Result<SharedTask> task_from(const Procedural& procedural, std::optional<std::uint64_t> seed, std::uint64_t episode) {
  return procedural.task(seed ? Rng(*seed).fork("episode", episode).below(limits::kSeed) : episode);
}

}  // namespace

Result<SharedTask> EpisodeTasks::task_of_episode(std::optional<std::uint64_t> seed, std::uint64_t episode) const {
  return std::visit([&](const auto& tasks) { return task_from(tasks, seed, episode); }, from);
}

}  // namespace unietp::python
