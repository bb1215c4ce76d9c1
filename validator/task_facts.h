#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "akb/knowledge.h"
#include "record/task_record.h"
#include "scene/scene.h"
#include "validator/text_row.h"

namespace unietp {

/// Facts of one task that are compared with other tasks and other files.
struct TaskFacts {
  std::string start_key;        // equal for equal template, binding, goal, home, start
  std::string text_key;         // equal for equal words in one home
  std::string home_key;         // equal for equal rooms, openings and furniture
  std::set<std::string> rooms;  // "ai2thor/kitchen": types of the rooms of handled objects at the start
  std::set<std::string> bound_rooms, bound_categories;  // "ai2thor/Mug": what the placeholders stand for; no values
  std::map<std::string, std::string> uses;              // of those that have words of the text's style: the kind
  std::optional<std::vector<TextRow>> steps;            // mode, number, action, arguments, success (0 or 1), failure;
                                                        // nullopt when a demonstration does not read
};

/// Lower case, letters and digits only, single blanks.
std::string plain_words(std::string_view text);

/// Key of the rooms, openings and fixed objects of a home, independent of their names.
std::string home_key_of(const Scene& home);

/// `home`: from its file; `start`: with the changes of the task. `shown`: the demonstrations that could be read; the
/// arguments of the one in M1 are the handled objects.
TaskFacts facts_of(const TaskRecord& task, const Scene& home, const Scene& start,
                   const std::map<Mode, DemonstrationRecord>& shown, const Knowledge& knowledge);

}  // namespace unietp
