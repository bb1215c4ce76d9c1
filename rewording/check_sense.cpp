#include "rewording/check_sense.h"

#include <string>

#include "sense/grade_goal.h"

namespace unietp {

std::vector<Problem> check_sense(const TaskRecord& task, const Formula& goal, const Resources& resources) {
  const auto simulator = simulator_named(task.simulator);
  if (!simulator) return {};  // found elsewhere
  const TaskSense sense =
      grade_goal(goal, resources.backend(*simulator).knowledge, resources.sense->common, resources.sense->words);
  std::vector<TaskRecord::SensePart> parts;
  for (const auto& part : sense.parts)
    parts.push_back({part.part, std::string(name_of(part.sense.grade)), part.sense.why});
  std::vector<Problem> problems;
  if (task.grade != name_of(sense.grade))
    problems.push_back(problem_in(ProblemKind::Sense, "",
                                  "is graded " + task.grade + ", but it is " + std::string(name_of(sense.grade))));
  else if (task.sense != parts)
    problems.push_back(problem_in(ProblemKind::Sense, "", "has other reasons for its grade than the tables give"));
  return problems;
}

}  // namespace unietp
