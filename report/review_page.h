#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "report/data_set.h"
#include "report/task_card.h"

namespace unietp {

/// A task in the list of the page.
struct ReviewEntry {
  std::string id, simulator, split, template_name, instruction, layout;
};
/// In the order of the file. Errors: those of reading.
Result<std::vector<ReviewEntry>> read_review_list(const FinishedSet& set, int threads);

/// The tasks of the list, one a call; nullopt after the last. Called by one thread at a time.
using ShownTaskSource = std::function<std::optional<Result<ShownTask>>()>;
/// Those of a folder. Errors: those of reading.
Result<ShownTaskSource> shown_tasks(const FinishedSet& set);

/// Pictures of a task. Called from several threads.
using PictureMaker = std::function<Result<StartPictures>(const TaskRecord&)>;

/// One self-contained page to accept, reject or edit tasks by. What a task shows is packed with that of other tasks of
/// its home, which have most of their drawing in common, and is unpacked when the task is shown. In memory stay the
/// list, what is packed, and at most 23 tasks of each home that wait for others of theirs. Equal input gives equal
/// bytes for any number of threads. Errors: the first of `tasks` and `pictures`; Io when the tasks are not those of the
/// list.
Result<std::string> review_page(const FinishedSet& set, const std::vector<ReviewEntry>& list,
                                const ShownTaskSource& tasks, int threads, const PictureMaker& pictures);

}  // namespace unietp
