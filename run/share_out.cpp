#include "run/share_out.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>

namespace unietp {
namespace {

using Table = std::vector<std::vector<int>>;

/// Moves one unit of a row that has some left toward a column that lacks some, over cells that may give or take
/// (a breadth-first augmenting path of the bipartite flow); false when there is no way.
bool augment(Table& table, const std::vector<std::vector<bool>>& allowed, std::size_t row, std::vector<int>& lacking) {
  const std::size_t rows = table.size(), columns = lacking.size();
  std::vector<std::optional<std::size_t>> row_of(columns), column_of(rows);  // predecessors on the path
  std::vector<bool> seen_row(rows, false), seen_column(columns, false);
  std::vector<std::size_t> open{row};
  seen_row[row] = true;
  for (std::size_t next = 0; next < open.size(); ++next) {
    const std::size_t from = open[next];
    for (std::size_t column = 0; column < columns; ++column) {
      if (seen_column[column] || !allowed[from][column]) continue;
      seen_column[column] = true;
      row_of[column] = from;
      if (lacking[column] > 0) {
        --lacking[column];
        std::size_t at = column;
        for (std::size_t giver = from;; giver = *row_of[at]) {
          ++table[giver][at];
          if (giver == row) return true;
          at = *column_of[giver];
          --table[giver][at];
        }
      }
      for (std::size_t other = 0; other < rows; ++other) {
        if (seen_row[other] || table[other][column] == 0) continue;
        seen_row[other] = true;
        column_of[other] = column;
        open.push_back(other);
      }
    }
  }
  return false;
}

}  // namespace

Table share_out(const std::vector<int>& rows, const std::vector<int>& columns,
                const std::vector<std::vector<bool>>& allowed) {
  const long long total = std::accumulate(rows.begin(), rows.end(), 0LL);
  if (total == 0 || total != std::accumulate(columns.begin(), columns.end(), 0LL)) return {};
  Table table(rows.size(), std::vector<int>(columns.size(), 0));
  std::vector<int> left = rows, lacking = columns;
  std::vector<std::tuple<long long, std::size_t, std::size_t>> fractions;  // largest first, then in order of the table
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (!allowed[r][c]) continue;
      const long long product = static_cast<long long>(rows[r]) * columns[c];
      table[r][c] = static_cast<int>(product / total);
      left[r] -= table[r][c];
      lacking[c] -= table[r][c];
      fractions.emplace_back(-(product % total), r, c);
    }
  }
  std::sort(fractions.begin(), fractions.end());
  for (const auto& [fraction, r, c] : fractions) {
    if (left[r] == 0 || lacking[c] == 0) continue;
    ++table[r][c];
    --left[r];
    --lacking[c];
  }
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (; left[r] > 0; --left[r]) {
      if (!augment(table, allowed, r, lacking)) return {};
    }
  }
  return table;
}

std::vector<std::size_t> spread_out(const std::vector<int>& counts) {
  std::vector<std::tuple<double, std::size_t>> places;  // the middle of each one's share of the whole, cell
  for (std::size_t cell = 0; cell < counts.size(); ++cell) {
    for (int k = 0; k < counts[cell]; ++k) places.emplace_back((k + 0.5) / counts[cell], cell);
  }
  std::sort(places.begin(), places.end());
  std::vector<std::size_t> order;
  order.reserve(places.size());
  for (const auto& [place, cell] : places) order.push_back(cell);
  return order;
}

}  // namespace unietp
