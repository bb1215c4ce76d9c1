#pragma once

#include <set>
#include <string>
#include <string_view>

#include "akb/knowledge.h"
#include "exports/finished_tasks.h"
#include "logic/monitor.h"

namespace unietp {

/// The id of a step's object, also where the command points at it with a box; "" for none.
std::string object_of(const StepRecord& step);

/// Rationales of a demonstration: whether the object of the next action is in view, what the agent holds, and what is
/// missing of the goal. Only objects that the agent was told about or has seen are named by id; in M3 none is.
class SftReasoning {
 public:
  SftReasoning(const FinishedTask& task, Mode mode, const Knowledge& knowledge);

  /// The rationale before step `index`. Call it in order of the steps; `before` is the scene at that time.
  std::string before_step(std::size_t index, const Scene& before);

 private:
  void observe(const Scene& scene);
  std::string sight(std::size_t index, const Scene& before) const;
  /// The next other object that will be handled; "" for none.
  std::string sought_after(std::size_t index, const Scene& before) const;
  std::string hand(const Scene& before) const;
  std::string name(const std::string& id, const Scene& scene) const;
  std::string kind(const std::string& id, const Scene& scene) const;
  std::string in_own_words(std::string_view text, const Scene& scene) const;

  const DemonstrationRecord& shown_;
  const Mode mode_;
  const Knowledge& knowledge_;
  std::set<std::string, std::less<>> known_, seen_;
  FactReader facts_;
  Monitor monitor_;
  Scene last_;  // that the monitor has observed
};

}  // namespace unietp
