#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace unietp {

/// Numbers of a row's key names, in the order in which a query gives them.
struct RowKey {
  std::uint32_t first = 0, second = 0, third = 0;
};

/// Rows of a table in the order of a key, found by numbers instead of by comparing texts.
class RowIndex {
 public:
  RowIndex() = default;
  /// One key a row; rows of equal keys stay in their order. `names`: more than every `first`.
  RowIndex(const std::vector<RowKey>& keys, std::size_t names);

  /// Rows whose key begins like this; none for a number that no row has.
  std::span<const std::uint32_t> with(std::uint32_t first) const;
  std::span<const std::uint32_t> with(std::uint32_t first, std::uint32_t second) const;
  std::span<const std::uint32_t> with(std::uint32_t first, std::uint32_t second, std::uint32_t third) const;

 private:
  std::span<const std::uint32_t> between(std::uint32_t first, std::uint64_t low, std::uint64_t high) const;

  std::vector<std::uint32_t> starts_;  // of each first number, and the end
  std::vector<std::uint64_t> rest_;    // second and third of each row, sorted within its first
  std::vector<std::uint32_t> rows_;
};

}  // namespace unietp
