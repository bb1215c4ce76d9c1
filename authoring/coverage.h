#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "authoring/trial.h"

namespace unietp {

/// A template on a simulator.
struct CoverageCell {
  bool claimed = false;                        // by the template's `simulators`
  int candidates = 0, accepted = 0;            // 0 of 0 when nothing was tried
  std::string example;                         // instruction of the first proven task, or ""
  std::vector<TemplateTrial::Reason> reasons;  // why the others were rejected, the most frequent first
  std::array<int, kModes.size()> steps{};      // of the proven tasks' demonstrations, summed by mode
};

/// A template on all simulators.
struct CoverageRow {
  std::string name;
  Split split = Split::Atomic;
  std::vector<std::string> predicates;  // of its goal, sorted
  std::array<CoverageCell, kSimulators.size()> cells;
};

/// Predicates and claimed simulators of templates, before any trial. In the order of `positions` in
/// Resources::templates.
std::vector<CoverageRow> coverage_of(const Resources& resources, const std::vector<std::size_t>& positions);

/// The claimed cells, each as (row, position in kSimulators), in order.
std::vector<std::pair<std::size_t, std::size_t>> claimed_cells(const std::vector<CoverageRow>& rows);
/// Of those, the ones for which no task was proven.
std::vector<std::pair<std::size_t, std::size_t>> empty_cells(const std::vector<CoverageRow>& rows);

/// How many of the templates claim a simulator and have the predicate in their goal.
struct PredicateUse {
  std::string predicate;
  std::array<int, kSimulators.size()> templates{};
};
/// Every predicate of the vocabulary, also those that no template uses; in its order.
std::vector<PredicateUse> predicate_uses(const std::vector<CoverageRow>& rows);

/// "7/10" for a claimed cell that was tried, "yes" for one that was not, "" for one that is not claimed.
std::string to_text(const CoverageCell& cell);

/// A page in Markdown: the table, the reasons for each empty cell, what the expert failed on, what the gates rejected,
/// and the predicates.
std::string coverage_page(const std::vector<CoverageRow>& rows, const std::vector<Mode>& modes, int tries,
                          std::uint64_t seed);

}  // namespace unietp
