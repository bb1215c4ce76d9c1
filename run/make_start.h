#pragma once

#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/result.h"
#include "grounding/episode.h"
#include "grounding/home.h"
#include "record/task_record.h"
#include "resources/resources.h"

namespace unietp {

/// Makes the starts of tasks again from what their records ask for, as the run made them. Thread-safe. Memory: the
/// prepared homes of a bounded number of layouts.
class StartMaker {
 public:
  explicit StartMaker(const Resources& resources) : resources_(resources) {}

  /// The episode of a task in its home. `goal`, `constraints`: those of the record, read. `pictured`: the run has the
  /// mode M3. Deterministic; depends on what the record asks for, its seed, slot and attempt, and the home. Errors:
  /// Schema for an unknown simulator, split, style or refinement; Unsatisfiable where there is no such start.
  Result<Episode> make(const TaskRecord& task, const Formula& goal, const std::vector<Formula>& constraints,
                       const std::shared_ptr<const Scene>& home, bool pictured);

 private:
  struct Prepared {
    std::shared_ptr<const Scene> scene;
    std::shared_ptr<const Home> home;
  };
  std::shared_ptr<const Home> prepared(const std::shared_ptr<const Scene>& scene);

  const Resources& resources_;
  std::mutex mutex_;
  std::map<std::string, Prepared> homes_;
  std::deque<std::string> kept_;  // in the order in which they were prepared
};

}  // namespace unietp
