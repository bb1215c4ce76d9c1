#include "akb/row_index.h"

#include <algorithm>
#include <numeric>

namespace unietp {
namespace {

std::uint64_t packed(std::uint64_t second, std::uint64_t third) { return second << 32U | third; }

/// Reorders `rows` by a number of each, keeping the order of equal ones: a counting sort, linear in rows and numbers.
template <class NumberOf>
void order_by(std::vector<std::uint32_t>& rows, const NumberOf& number_of) {
  std::uint32_t most = 0;
  for (const auto row : rows) most = std::max(most, number_of(row));
  std::vector<std::uint32_t> at(most + 2, 0);
  for (const auto row : rows) ++at[number_of(row) + 1];
  std::partial_sum(at.begin(), at.end(), at.begin());
  std::vector<std::uint32_t> ordered(rows.size());
  for (const auto row : rows) ordered[at[number_of(row)]++] = row;
  rows = std::move(ordered);
}

}  // namespace

RowIndex::RowIndex(const std::vector<RowKey>& keys, std::size_t names) : starts_(names + 1, 0), rows_(keys.size()) {
  std::iota(rows_.begin(), rows_.end(), 0U);
  order_by(rows_, [&](std::uint32_t row) { return keys[row].third; });
  order_by(rows_, [&](std::uint32_t row) { return keys[row].second; });
  order_by(rows_, [&](std::uint32_t row) { return keys[row].first; });
  rest_.reserve(keys.size());
  for (const auto row : rows_) {
    ++starts_[keys[row].first + 1];
    rest_.push_back(packed(keys[row].second, keys[row].third));
  }
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
}

std::span<const std::uint32_t> RowIndex::between(std::uint32_t first, std::uint64_t low, std::uint64_t high) const {
  if (first + std::size_t{1} >= starts_.size()) return {};
  const auto begin = rest_.begin() + starts_[first], end = rest_.begin() + starts_[first + 1];
  const auto from = std::lower_bound(begin, end, low), to = std::upper_bound(from, end, high);
  return std::span(rows_).subspan(static_cast<std::size_t>(from - rest_.begin()), static_cast<std::size_t>(to - from));
}

std::span<const std::uint32_t> RowIndex::with(std::uint32_t first) const { return between(first, 0, UINT64_MAX); }
std::span<const std::uint32_t> RowIndex::with(std::uint32_t first, std::uint32_t second) const {
  return between(first, packed(second, 0), packed(second, UINT32_MAX));
}
std::span<const std::uint32_t> RowIndex::with(std::uint32_t first, std::uint32_t second, std::uint32_t third) const {
  return between(first, packed(second, third), packed(second, third));
}

}  // namespace unietp
