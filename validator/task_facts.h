#pragma once

#include <set>
#include <string>
#include <string_view>

#include "record/task_record.h"
#include "scene/scene.h"

namespace unietp {

/// What of one task is compared with others.
struct TaskFacts {
  std::string start_key;        // equal for equal template, binding, goal, home, start
  std::string text_key;         // equal for equal words in one home
  std::string home_key;         // equal for equal rooms, openings and furniture
  std::set<std::string> rooms;  // "ai2thor/kitchen": types of those where what is handled stands at the start
};

/// Lower case, letters and digits only, single blanks.
std::string plain_words(std::string_view text);

/// Rooms, openings, and where what never moves stands; whatever they are called.
std::string home_key_of(const Scene& home);

/// `home` as its file has it, `start` as the task makes it. `shown`: the demonstration in M1, whose handled things tell
/// which rooms the task is in; nullptr when there is none that reads.
TaskFacts facts_of(const TaskRecord& task, const Scene& home, const Scene& start, const DemonstrationRecord* shown);

}  // namespace unietp
