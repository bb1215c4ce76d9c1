#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/result.h"
#include "environment/environment.h"

namespace unietp {

/// Chooses the task of an environment's episode, both counted from 0. Called from several threads at once; must depend
/// on its arguments only.
using TaskOfEpisode = std::function<Result<SharedTask>(std::size_t environment, std::uint64_t episode)>;

/// Takes what a step gave one environment. Called on the thread that stepped it, several at once.
using TakeStep = std::function<void(std::size_t environment, StepResult step)>;

/// Environments that are stepped together on several threads. Autoreset mode: next step, as Gymnasium's vector
/// environments have it by default: the step that ends an episode gives its last observation; the next step ignores the
/// answer, begins the environment's next episode and gives its first observation with reward 0 and both ends false.
/// Results are equal, byte for byte, to those of single environments, for any number of threads.
class EnvironmentBatch {
 public:
  /// Errors: those of `task_of` and of Environment::make, of the first environment that has one.
  static Result<EnvironmentBatch> make(std::size_t count, int threads, const Settings& settings, TaskOfEpisode task_of);
  EnvironmentBatch(EnvironmentBatch&&) noexcept;
  EnvironmentBatch& operator=(EnvironmentBatch&&) noexcept;
  ~EnvironmentBatch();

  /// How many environments.
  std::size_t size() const;
  /// For reading; while a step runs, only from its TakeStep and for that environment.
  const Environment& at(std::size_t environment) const;
  Environment& at(std::size_t environment);

  /// Begins the next episode of each. Errors: those of `task_of`.
  Result<std::vector<Observation>> reset();
  /// One answer for each environment, in their order.
  /// Errors: Usage when there are not as many answers as environments; those of `task_of` where an episode begins.
  Result<std::vector<StepResult>> step(std::span<const std::string> answers);
  Result<std::vector<StepResult>> step(std::span<const Answer> answers);
  /// The same, with results handed over as they come, so that what is done with them is shared by the threads too.
  /// After an error some were not handed over.
  Result<Done> step(std::span<const std::string> answers, const TakeStep& take);
  Result<Done> step(std::span<const Answer> answers, const TakeStep& take);
  /// What each camera shows, made on the threads.
  std::vector<Picture> pictures() const;
  /// Depth, surface normals and objects of those pictures, made on the threads (Environment::channels).
  std::vector<Channels> channels() const;

 private:
  struct Impl;
  explicit EnvironmentBatch(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace unietp
