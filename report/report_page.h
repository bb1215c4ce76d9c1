#pragma once

#include <string>
#include <vector>

#include "report/data_set.h"
#include "report/statistics.h"
#include "report/task_card.h"

namespace unietp {

/// A task as the one with this rank, from 0, in the file among those of its split and simulator.
struct ExamplePlace {
  std::string split, simulator;
  int rank = 0;
  auto operator<=>(const ExamplePlace&) const = default;
};

/// The places of at most `count` examples: round-robin over simulators and splits, spread over the file. Deterministic.
std::vector<ExamplePlace> example_places(const DatasetStatistics& statistics, std::size_t count);

/// The tasks at these places, in their order. Only they stay in memory. Deterministic for any number of threads.
/// Errors: those of reading; Io when one of them is not there.
Result<std::vector<ShownTask>> read_examples(const FinishedSet& set, const std::vector<ExamplePlace>& places,
                                             int threads);

/// A task shown on the page.
struct ReportExample {
  ShownTask task;
  StartPictures pictures;
};

/// One self-contained page: the figures of `unietp stats` as charts and tables, and examples to page through.
std::string report_page(const DatasetStatistics& statistics, const std::vector<ReportExample>& examples);

}  // namespace unietp
