#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "environment/task_source.h"
#include "procedural/procedural.h"

namespace unietp::python {

/// Where the tasks of episodes come from: a data set, or new ones without end. Thread-safe.
struct EpisodeTasks {
  std::variant<TaskSource, Procedural> from;

  /// The task of an episode, counted from 0. Of a data set without a seed: in the order of the file, again and again;
  /// with a seed: in an order that depends on it only, and in the order of the next seed after the last task.
  /// Procedural: of a seed drawn from both, or of the seed `episode` without one. Errors: those of the two.
  Result<SharedTask> task_of_episode(std::optional<std::uint64_t> seed, std::uint64_t episode) const;
};

}  // namespace unietp::python
