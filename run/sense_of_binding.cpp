#include "run/sense_of_binding.h"

#include <memory>
#include <string>
#include <vector>

namespace unietp {

BindingCheck at_least(Grade least, const Template& source, const Resources& resources, Simulator simulator) {
  if (least == Grade::Senseless) return {};
  std::vector<std::string> placeholders;
  for (const auto& parameter : source.parameters) placeholders.push_back(parameter.name);
  const auto sketch = std::make_shared<const GoalSketch>(source.goal, placeholders,
                                                         resources.piece_grades[static_cast<std::size_t>(simulator)],
                                                         resources.backend(simulator).knowledge);
  return [sketch, least](const Binding& bound, const Parameter& parameter, const std::string& category) {
    return sketch->grade_of_step(bound, {parameter.name, category}) >= least;
  };
}

std::optional<Grade> best_grade(Grade wanted, const Template& source, const Resources& resources, Simulator simulator,
                                const Binding& fixed) {
  for (const Grade least : {Grade::Usual, Grade::Tolerable, Grade::Senseless}) {
    if (least > wanted) continue;
    const BindingWishes wishes{fixed, {}, at_least(least, source, resources, simulator)};
    if (sample_binding(source, resources.backend(simulator).knowledge, {}, wishes, Rng(0))) return least;
  }
  return std::nullopt;
}

TaskSense sense_of_task(const Specification& specification, const Resources& resources) {
  return grade_goal(specification.goal, resources.backend(specification.simulator).knowledge, resources.sense->common,
                    resources.sense->words);
}

}  // namespace unietp
