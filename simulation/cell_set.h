#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace unietp {

/// A set of grid cells, one bit per cell: copies and flood fills of a whole street take microseconds.
class CellSet {
 public:
  CellSet() = default;
  /// The empty set on a grid.
  CellSet(int width, int height);

  /// False for cells outside of the grid.
  bool has(int x, int y) const {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return false;
    return ((bits_[word(x, y)] >> (x % kWord)) & 1U) != 0;
  }
  /// The cell must lie in the grid.
  void set(int x, int y, bool there) {
    const std::uint64_t bit = std::uint64_t{1} << (x % kWord);
    std::uint64_t& bits = bits_[word(x, y)];
    bits = there ? bits | bit : bits & ~bit;
  }
  /// Number of cells of a row between columns `from` and `to`, both included and in the grid.
  int count(int y, int from, int to) const;
  /// Whether it contains all cells of that range that another set of the same grid contains.
  bool covers(const CellSet& other, int y, int from, int to) const;
  /// The 4-connected component of the set that contains the cell; empty when the set does not contain it.
  CellSet connected_to(int x, int y) const;
  /// The same, computed from another set of the same grid whose component of that cell is `reached`. When the sets
  /// differ in one small region, only that region is searched.
  CellSet connected_to(int x, int y, const CellSet& before, const CellSet& reached) const;
  bool operator==(const CellSet&) const = default;

 private:
  static constexpr int kWord = 64;
  struct Window {  // columns and rows, from low to before high
    int low_x = 0, high_x = 0, low_y = 0, high_y = 0;
  };
  /// A window around all cells in which the two differ, with a margin.
  Window around_differences(const CellSet& other) const;
  std::size_t word(int x, int y) const {
    return static_cast<std::size_t>(y) * words_ + static_cast<std::size_t>(x) / kWord;
  }

  int width_ = 0, height_ = 0;
  std::size_t words_ = 0;  // a row
  std::vector<std::uint64_t> bits_;
};

}  // namespace unietp
