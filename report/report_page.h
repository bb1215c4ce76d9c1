#pragma once

#include <string>
#include <vector>

#include "report/data_set.h"
#include "report/statistics.h"
#include "report/task_card.h"

namespace unietp {

/// Positions in `set.tasks` of `count` examples: round-robin over simulators and splits, spread over the file.
/// Deterministic.
std::vector<std::size_t> example_tasks(const FinishedSet& set, std::size_t count);

/// A task shown on the page.
struct ReportExample {
  const TaskRecord* task = nullptr;
  std::vector<PlanCard> plans;
  StartPictures pictures;
};

/// One self-contained page: the figures of `unietp stats` as charts and tables, and examples to page through.
std::string report_page(const DatasetStatistics& statistics, const std::vector<ReportExample>& examples);

}  // namespace unietp
