#pragma once

#include <vector>

namespace unietp {

/// A table of counts with the sums of its rows and columns given (both add up to the same number), as near as whole
/// numbers allow to what independent shares would give: row sum times column sum over the total. Cells where `allowed`
/// is false stay empty. Result: [row][column], or nothing when no table has these sums. Deterministic.
std::vector<std::vector<int>> share_out(const std::vector<int>& rows, const std::vector<int>& columns,
                                        const std::vector<std::vector<bool>>& allowed);

/// An order of the cells in which each of them comes as often as it counts, spread evenly: of every prefix, each cell
/// has about its share. Positions in `counts`.
std::vector<std::size_t> spread_out(const std::vector<int>& counts);

}  // namespace unietp
