#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scores/figures.h"
#include "scores/result_table.h"

namespace unietp {

// Cells of the tables of results.

/// The success rate in whole percent with its interval; if episodes errored, also with its bounds. "–" for none.
ResultCell success_cell(const Figures& figures);
/// "72.4": a share in percent with one decimal, halves rounded up; "–" of nothing.
std::string share_text(int count, int of);
/// A number with so many decimals.
std::string fixed_text(double value, int decimals);
/// "run=0&mode=M1": which episodes a cell counts. Values are encoded for a URL.
std::string filter_text(std::size_t run, const std::vector<std::pair<std::string, std::string>>& conditions);
/// Marks the best rates of each column from `first` on, if there are several rows.
void mark_best(ResultTable& table, std::size_t first);

}  // namespace unietp
