#include "simulation/cell_set.h"

#include <algorithm>
#include <bit>
#include <span>

namespace unietp {
namespace {

/// The bits of `open` that hang together with one of `some`, which are among them.
std::uint64_t spread(std::uint64_t some, std::uint64_t open) {
  std::uint64_t up = open, down = open;
  for (int by = 1; by < 64; by *= 2) {
    some |= up & (some << by);
    up &= up << by;
  }
  for (int by = 1; by < 64; by *= 2) {
    some |= down & (some >> by);
    down &= down >> by;
  }
  return some;
}

/// The same along a row of words.
void spread(std::span<std::uint64_t> some, std::span<const std::uint64_t> open) {
  std::uint64_t carry = 0;
  for (std::size_t w = 0; w < some.size(); ++w) {
    const std::uint64_t here = some[w] | (open[w] & carry);
    some[w] = here == 0 ? 0 : spread(here, open[w]);
    carry = some[w] >> 63;
  }
  carry = 0;
  for (std::size_t w = some.size(); w-- > 0;) {
    const std::uint64_t here = some[w] | (open[w] & carry);
    if (here != some[w]) some[w] = spread(here, open[w]);
    carry = some[w] << 63;
  }
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
    const int end = std::min(to + 1, (x / kWord + 1) * kWord);  // of the cells that share a word
    const std::uint64_t all = ~std::uint64_t{0} >> (kWord - (end - x));
    found += std::popcount((bits_[word(x, y)] >> (x % kWord)) & all);
    x = end;
  }
  return found;
}

CellSet CellSet::connected_to(int x, int y) const {
  CellSet found(width_, height_);
  if (!has(x, y)) return found;
  found.set(x, y, true);
  std::vector<int> due{y};  // rows whose cells have not been spread yet
  std::vector<bool> is_due(static_cast<std::size_t>(height_), false);
  while (!due.empty()) {
    const int row = due.back();
    due.pop_back();
    is_due[static_cast<std::size_t>(row)] = false;
    const std::size_t here = word(0, row);
    spread(std::span(found.bits_).subspan(here, words_), std::span(bits_).subspan(here, words_));
    for (const int next : {row - 1, row + 1}) {
      if (next < 0 || next >= height_) continue;
      const std::size_t there = word(0, next);
      std::uint64_t fresh = 0;
      for (std::size_t w = 0; w < words_; ++w) {
        const std::uint64_t more = found.bits_[here + w] & bits_[there + w] & ~found.bits_[there + w];
        found.bits_[there + w] |= more;
        fresh |= more;
      }
      if (fresh == 0 || is_due[static_cast<std::size_t>(next)]) continue;
      is_due[static_cast<std::size_t>(next)] = true;
      due.push_back(next);
    }
  }
  return found;
}

}  // namespace unietp
