#pragma once

#include <functional>
#include <memory>

#include "core/result.h"
#include "environment/environment.h"
#include "evaluation/episode_record.h"

namespace unietp {

/// Looks on while episodes are played, one after the other. Nothing of it is recorded. Each thread has one of its own.
class EpisodeWatcher {
 public:
  virtual ~EpisodeWatcher() = default;
  /// Forgets the episode before.
  virtual void begin(const Environment& start) = 0;
  /// Before what an agent said is done; null: it could not be read.
  virtual void before_reply(const Answer* answer, const Environment& now) = 0;
  /// After it. `unreadable` is that of the step.
  virtual void after_reply(const std::string& unreadable, const StepResult& result, const Environment& now) = 0;
  /// The episode is over, or no further reply could be had. Errors: those of what it keeps.
  virtual Result<Done> end(const EpisodeRecord& record, const Environment& last) = 0;
};

/// Makes one for a thread; called from that thread. May be empty: nobody looks on.
using WatcherMaker = std::function<std::unique_ptr<EpisodeWatcher>()>;

}  // namespace unietp
