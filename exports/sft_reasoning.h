#pragma once

#include <set>
#include <string>
#include <string_view>

#include "akb/knowledge.h"
#include "exports/finished_tasks.h"
#include "logic/monitor.h"

namespace unietp {

/// What the agent of a demonstration can say of itself before a step: whether what it is about to handle is in view,
/// what it holds, and what of the goal is still missing. Only things that it was told of or has seen are named by id;
/// in M3 none is.
class SftReasoning {
 public:
  SftReasoning(const FinishedTask& task, Mode mode, const Knowledge& knowledge);

  /// Before step `index`; steps in order, `before` the scene then.
  std::string before_step(std::size_t index, const Scene& before);

 private:
  std::string sight(std::size_t index, const Scene& before) const;
  /// What the next other thing to be handled is, "" when there is none.
  std::string sought_after(std::size_t index, const Scene& before) const;
  std::string hand(const Scene& before) const;
  std::string target_of(const StepRecord& step) const;
  std::string name(const std::string& id, const Scene& scene) const;
  std::string kind(const std::string& id, const Scene& scene) const;
  std::string in_own_words(std::string_view text, const Scene& scene) const;

  const DemonstrationRecord& shown_;
  const Mode mode_;
  const Knowledge& knowledge_;
  std::set<std::string, std::less<>> told_, seen_;
  FactReader facts_;
  Monitor monitor_;
};

}  // namespace unietp
