#pragma once

#include <string>
#include <vector>

#include "report/data_set.h"
#include "report/statistics.h"
#include "report/task_card.h"

namespace unietp {

/// Positions in `set.tasks` of examples: of each simulator and split one after the other, spread over the file, until
/// there are `count`. Deterministic.
std::vector<std::size_t> example_tasks(const FinishedSet& set, std::size_t count);

struct ReportExample {
  const TaskRecord* task = nullptr;
  std::vector<PlanCard> plans;
  StartPictures pictures;
};

/// One self-contained page: the figures of stats as charts with the tables behind them, and examples to page through.
std::string report_page(const DatasetStatistics& statistics, const std::vector<ReportExample>& examples);

}  // namespace unietp
