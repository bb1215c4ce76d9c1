#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace unietp {

/// Cells of a grid, a bit each: a copy and a flood of a whole street cost microseconds.
class CellSet {
 public:
  CellSet() = default;
  /// None of the grid's cells.
  CellSet(int width, int height);

  /// False for what lies outside of the grid.
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
  /// How many of a row's cells it has from `from` to `to`, both included and in the grid.
  int count(int y, int from, int to) const;
  /// Whether it has all of these that another set of the same grid has.
  bool covers(const CellSet& other, int y, int from, int to) const;
  /// The cells that one gets to from that one by steps to the four neighbours, it among them, without leaving the set;
  /// none when the set does not have it.
  CellSet connected_to(int x, int y) const;
  /// The same, by what is known of another set of the same grid: `reached` is what it has connected to that cell. Where
  /// little differs, and that in one place, only a look around there is taken.
  CellSet connected_to(int x, int y, const CellSet& before, const CellSet& reached) const;
  bool operator==(const CellSet&) const = default;

 private:
  static constexpr int kWord = 64;
  struct Window {  // columns and rows, from low to before high
    int low_x = 0, high_x = 0, low_y = 0, high_y = 0;
  };
  /// All cells that the two do not both have or lack, and some around them.
  Window around_differences(const CellSet& other) const;
  std::size_t word(int x, int y) const {
    return static_cast<std::size_t>(y) * words_ + static_cast<std::size_t>(x) / kWord;
  }

  int width_ = 0, height_ = 0;
  std::size_t words_ = 0;  // a row
  std::vector<std::uint64_t> bits_;
};

}  // namespace unietp
