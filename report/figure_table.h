#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "report/statistics.h"

namespace unietp {

/// A table of figures, as printed and as shown with a chart.
struct FigureTable {
  std::string id;                              // "plan-lengths"; the same for every data set
  std::string title;                           // "Plan lengths"
  std::string note;                            // what is counted; "" when the title says it
  std::vector<std::string> columns;            // the first names the rows
  std::vector<std::vector<std::string>> rows;  // as long as `columns`
};

/// Every figure of one data set, or of several side by side: a column each.
std::vector<FigureTable> tables_of(std::span<const DatasetStatistics> sets);

/// The tables as plain text, numbers to the right; at most so many rows of each.
std::string table_text(const std::vector<FigureTable>& tables, std::size_t most_rows);

/// "1,234"
std::string count_text(int count);
/// "12.3": one decimal.
std::string decimal_text(double value);
/// "12.3 %" for 0.123.
std::string percent_text(double share);

}  // namespace unietp
