#pragma once

#include <functional>
#include <string>
#include <vector>

#include "report/data_set.h"
#include "report/task_card.h"

namespace unietp {

/// Pictures of the task at a position of the set. Called from several threads.
using PictureMaker = std::function<Result<StartPictures>(std::size_t)>;

/// One self-contained page to accept, reject or edit tasks by. What a task shows is packed with that of other tasks of
/// its home, which have most of their drawing in common, and is unpacked when the task is shown. Equal input gives
/// equal bytes for any number of threads. Errors: the first of `pictures`, in the order of the homes.
Result<std::string> review_page(const FinishedSet& set, const std::vector<std::vector<PlanCard>>& plans, int threads,
                                const PictureMaker& pictures);

}  // namespace unietp
