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
/// What a field of an episode has to be, so that a cell counts the episode: {"mode", "M1"}. The fields are those of the
/// report's list of episodes (evaluation_page.cpp).
using Condition = std::pair<std::string, std::string>;
/// "run=0&mode=M1": which episodes a cell counts. Values are encoded for a URL.
std::string filter_text(std::size_t run, const std::vector<Condition>& conditions);
/// The run that a filter names.
std::size_t run_of(const std::string& filter);
/// A text as a part of a URL: all but letters, digits and "-_./" is encoded.
std::string in_url(const std::string& text);
/// Marks the best rates of each column from `first` on, if there are several rows.
void mark_best(ResultTable& table, std::size_t first);

}  // namespace unietp
