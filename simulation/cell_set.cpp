#include "simulation/cell_set.h"

#include <algorithm>
#include <bit>
#include <span>
#include <utility>

namespace unietp {
namespace {

/// The bits of `open` that are connected to one of `some`, a subset of `open`.
std::uint64_t spread(std::uint64_t some, std::uint64_t open) {
  some |= open & ~(open + some);  // the carry runs to the upper end of each connected run
  std::uint64_t down = open;
  for (int by = 1; by < 64; by *= 2) {
    some |= down & (some >> by);
    down &= down >> by;
  }
  return some;
}

/// A range of words of a row, both ends included; empty at first.
struct Stretch {
  std::size_t from = 1, to = 0;
  bool empty() const { return from > to; }
  void take_in(std::size_t word) {
    if (empty()) from = to = word;
    from = std::min(from, word);
    to = std::max(to, word);
  }
};

/// The same along a row of which only the words `fresh` changed. Returns the words that it changed.
Stretch spread(std::span<std::uint64_t> some, std::span<const std::uint64_t> open, Stretch fresh) {
  for (std::size_t w = fresh.from; w < some.size(); ++w) {
    const std::uint64_t carry = w == 0 ? 0 : some[w - 1] >> 63;
    const std::uint64_t here = some[w] | (open[w] & carry);
    if (w > fresh.to && here == some[w]) break;
    some[w] = spread(here, open[w]);
    fresh.take_in(w);
  }
  for (std::size_t w = fresh.to + 1; w-- > 0;) {
    const std::uint64_t carry = w + 1 == some.size() ? 0 : some[w + 1] << 63;
    const std::uint64_t here = some[w] | (open[w] & carry);
    if (here != some[w]) {
      some[w] = spread(here, open[w]);
      fresh.take_in(w);
    } else if (w < fresh.from) {
      break;
    }
  }
  return fresh;
}

}  // namespace

CellSet::CellSet(int width, int height)
    : width_(width),
      height_(height),
      words_(static_cast<std::size_t>(width + kWord - 1) / kWord),
      bits_(words_ * static_cast<std::size_t>(height), 0) {}

int CellSet::count(int y, int from, int to) const {
  int found = 0;
  for (int x = from; x <= to;) {
    const int end = std::min(to + 1, (x / kWord + 1) * kWord);  // of the cells in one word
    const std::uint64_t all = ~std::uint64_t{0} >> (kWord - (end - x));
    found += std::popcount((bits_[word(x, y)] >> (x % kWord)) & all);
    x = end;
  }
  return found;
}

bool CellSet::covers(const CellSet& other, int y, int from, int to) const {
  for (int x = from; x <= to;) {
    const int end = std::min(to + 1, (x / kWord + 1) * kWord);
    const std::uint64_t all = ~std::uint64_t{0} >> (kWord - (end - x));
    const std::size_t here = word(x, y);
    if (((other.bits_[here] & ~bits_[here]) >> (x % kWord) & all) != 0) return false;
    x = end;
  }
  return true;
}

CellSet CellSet::connected_to(int x, int y) const {
  CellSet found(width_, height_);
  if (!has(x, y)) return found;
  found.set(x, y, true);
  std::vector<Stretch> fresh(
      static_cast<std::size_t>(height_));  // by row: words that have not been spread to the neighboring rows
  fresh[static_cast<std::size_t>(y)].take_in(static_cast<std::size_t>(x) / kWord);
  std::vector<int> due{y};  // rows with fresh words
  while (!due.empty()) {
    const int row = due.back();
    due.pop_back();
    const std::size_t here = word(0, row);
    const Stretch spreads = spread(std::span(found.bits_).subspan(here, words_), std::span(bits_).subspan(here, words_),
                                   std::exchange(fresh[static_cast<std::size_t>(row)], {}));
    for (const int next : {row - 1, row + 1}) {
      if (next < 0 || next >= height_) continue;
      const std::size_t there = word(0, next);
      Stretch& fresh_there = fresh[static_cast<std::size_t>(next)];
      const bool was_due = !fresh_there.empty();
      for (std::size_t w = spreads.from; w <= spreads.to; ++w) {
        const std::uint64_t more = found.bits_[here + w] & bits_[there + w] & ~found.bits_[there + w];
        if (more == 0) continue;
        found.bits_[there + w] |= more;
        fresh_there.take_in(w);
      }
      if (!was_due && !fresh_there.empty()) due.push_back(next);
    }
  }
  return found;
}

CellSet::Window CellSet::around_differences(const CellSet& other) const {
  constexpr int kAround = 5;  // about the width of a detour around an open door
  Window found{width_, 0, height_, 0};
  for (int y = 0; y < height_; ++y) {
    for (std::size_t w = word(0, y); w < word(0, y) + words_; ++w) {
      const std::uint64_t differ = bits_[w] ^ other.bits_[w];
      if (differ == 0) continue;
      const int first = static_cast<int>(w - word(0, y)) * kWord;
      found.low_x = std::min(found.low_x, first + std::countr_zero(differ) - kAround);
      found.high_x = std::max(found.high_x, first + kWord - std::countl_zero(differ) + kAround);
      found.low_y = std::min(found.low_y, y - kAround);
      found.high_y = std::max(found.high_y, y + 1 + kAround);
    }
  }
  return {std::max(0, found.low_x), std::min(width_, found.high_x), std::max(0, found.low_y),
          std::min(height_, found.high_y)};
}

CellSet CellSet::connected_to(int x, int y, const CellSet& before, const CellSet& reached) const {
  if (!has(x, y) || !reached.has(x, y)) return connected_to(x, y);
  if (bits_ == before.bits_) return reached;
  constexpr int kWorthwhile = 8;  // minimum width for which the local search is faster
  const Window around = around_differences(before);
  const int wide = around.high_x - around.low_x, high = around.high_y - around.low_y;
  if (wide * high > width_ * height_ / kWorthwhile) return connected_to(x, y);
  const auto each = [&](const auto& look) {
    for (int j = around.low_y; j < around.high_y; ++j) {
      for (int i = around.low_x; i < around.high_x; ++i) {
        if (!look(i, j)) return false;
      }
    }
    return true;
  };
  CellSet here(wide, high);
  int from_x = -1, from_y = -1;
  each([&](int i, int j) {
    here.set(i - around.low_x, j - around.low_y, has(i, j));
    if (has(i, j) && reached.has(i, j)) from_x = i, from_y = j;
    return true;
  });
  if (from_x < 0) return connected_to(x, y);
  // If the cells of the window that were reached are still connected in it, paths through the window remain. If no cell
  // that was free but not reached is reached now, no path leads farther than before.
  const CellSet now = here.connected_to(from_x - around.low_x, from_y - around.low_y);
  CellSet found = reached;
  const bool as_before = each([&](int i, int j) {
    const bool there = now.has(i - around.low_x, j - around.low_y);
    found.set(i, j, there);
    if (!has(i, j) || there == reached.has(i, j)) return true;
    return there && !before.has(i, j);
  });
  return as_before ? found : connected_to(x, y);
}

}  // namespace unietp
