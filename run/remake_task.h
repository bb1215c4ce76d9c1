#pragma once

#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "annotator/instruction.h"
#include "core/result.h"
#include "dataset/configuration.h"
#include "grounding/episode.h"
#include "grounding/home.h"
#include "record/task_record.h"
#include "resources/resources.h"

namespace unietp {

/// A task's start and first instruction, as the run made them.
struct Remade {
  Episode episode;
  Instruction instruction;  // text "": its template, whose phrasings it may have, is not known here
};

/// Makes starts and instructions of tasks again from what their records ask for, as the run made them. Thread-safe.
/// Memory: the prepared homes of a bounded number of layouts.
class TaskRemaker {
 public:
  explicit TaskRemaker(const Resources& resources) : resources_(resources) {}

  /// A task in its home. `goal`, `constraints`: those of the record, read. Deterministic; depends on what the record
  /// asks for, its seed, slot and attempt, the home, and the modes and phrasings of the run. Errors: Schema for an
  /// unknown simulator, split, style or refinement; Unsatisfiable where there is no such start or no words.
  Result<Remade> make(const RunConfiguration& configuration, const TaskRecord& task, const Formula& goal,
                      const std::vector<Formula>& constraints, const std::shared_ptr<const Scene>& home);

 private:
  struct Prepared {
    std::shared_ptr<const Scene> scene;
    std::shared_ptr<const Home> home;
  };
  std::shared_ptr<const Home> prepared(const std::shared_ptr<const Scene>& scene, bool given);

  const Resources& resources_;
  std::mutex mutex_;
  std::map<std::string, Prepared> homes_;
  std::deque<std::string> kept_;  // in the order in which they were prepared
};

}  // namespace unietp
