#pragma once

#include <set>
#include <string>
#include <string_view>

#include "record/task_record.h"
#include "scene/scene.h"

namespace unietp {

/// Facts of one task that are compared with other tasks.
struct TaskFacts {
  std::string start_key;        // equal for equal template, binding, goal, home, start
  std::string text_key;         // equal for equal words in one home
  std::string home_key;         // equal for equal rooms, openings and furniture
  std::set<std::string> rooms;  // "ai2thor/kitchen": types of the rooms of handled objects at the start
};

/// Lower case, letters and digits only, single blanks.
std::string plain_words(std::string_view text);

/// Key of the rooms, openings and fixed objects of a home, independent of their names.
std::string home_key_of(const Scene& home);

/// `home`: from its file; `start`: with the changes of the task. `shown`: the demonstration in M1, whose arguments are
/// the handled objects; nullptr when none could be read.
TaskFacts facts_of(const TaskRecord& task, const Scene& home, const Scene& start, const DemonstrationRecord* shown);

}  // namespace unietp
