#pragma once

#include <set>
#include <string>
#include <vector>

#include "validator/folder_reading.h"
#include "validator/problem.h"
#include "validator/task_facts.h"

namespace unietp {

/// Tasks that have a start, or the words in a home, in common with an earlier one. `facts` in the order of the tasks;
/// where one did not read, its keys are "".
std::vector<Problem> find_repeats(const FolderReading& set, const std::vector<TaskFacts>& facts);

/// What of a data set may not come back in another one.
struct SetPrint {
  std::string folder;  // for messages
  std::uint64_t seed = 0;
  std::set<std::string> layouts, home_keys, words;
};
/// Reads tasks, manifest and start scenes of a finished folder; several scenes at a time. Errors: those of reading.
Result<SetPrint> print_of(const std::filesystem::path& folder, int threads);

/// Every task whose home or words are in the other data set, and the seed if it is shared. As `facts` above.
std::vector<Problem> find_leaks(const FolderReading& set, std::uint64_t seed, const std::vector<TaskFacts>& facts,
                                const SetPrint& other);

}  // namespace unietp
