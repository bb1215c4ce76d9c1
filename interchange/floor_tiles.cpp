#include "interchange/floor_tiles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace unietp {
namespace {

using Cell = std::pair<int, int>;  // column and row of a grid line's crossing or of a cell's lower corner

std::vector<double> lines_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

/// The single loop of the directed sides, or nothing when they make several or touch at a corner.
std::vector<Cell> loop_of(const std::map<Cell, Cell>& sides, std::size_t count) {
  std::vector<Cell> loop;
  if (sides.size() != count || sides.empty()) return loop;
  Cell at = sides.begin()->first;
  do {
    loop.push_back(at);
    at = sides.at(at);
  } while (at != loop.front() && loop.size() <= count);
  if (loop.size() != count) loop.clear();
  return loop;
}

}  // namespace

Tile bounds_of(const std::vector<Tile>& tiles) {
  Tile all = tiles.front();
  for (const Tile& tile : tiles) all.low = all.low.cwiseMin(tile.low), all.high = all.high.cwiseMax(tile.high);
  return all;
}

std::vector<Vec2> corners_of(const Tile& tile) {
  return {tile.low, {tile.high.x(), tile.low.y()}, tile.high, {tile.low.x(), tile.high.y()}};
}

void align(const std::vector<Tile*>& tiles, double gap_m) {
  for (const int axis : {0, 1}) {
    std::vector<double*> values;
    for (Tile* tile : tiles) values.push_back(&tile->low[axis]), values.push_back(&tile->high[axis]);
    std::sort(values.begin(), values.end(), [](const double* a, const double* b) { return *a < *b; });
    double line = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i == 0 || *values[i] - line > gap_m) line = *values[i];
      *values[i] = line;
    }
  }
}

std::optional<std::vector<Vec2>> outline_of(const std::vector<Tile>& tiles, const std::vector<Tile>& holes) {
  constexpr std::size_t kMostLines = 200;
  std::vector<double> xs, ys;
  for (const auto* list : {&tiles, &holes}) {
    for (const Tile& tile : *list) {
      xs.insert(xs.end(), {tile.low.x(), tile.high.x()});
      ys.insert(ys.end(), {tile.low.y(), tile.high.y()});
    }
  }
  xs = lines_of(std::move(xs)), ys = lines_of(std::move(ys));
  if (xs.size() > kMostLines || ys.size() > kMostLines || xs.empty()) return std::nullopt;
  const auto place = [](const std::vector<double>& lines, double value) {
    return static_cast<int>(std::lower_bound(lines.begin(), lines.end(), value) - lines.begin());
  };
  const int columns = static_cast<int>(xs.size()) - 1, rows = static_cast<int>(ys.size()) - 1;
  std::vector<char> cells((xs.size() - 1) * (ys.size() - 1), 0);
  const auto index = [&](int x, int y) {
    return static_cast<std::size_t>(y) * (xs.size() - 1) + static_cast<std::size_t>(x);
  };
  const auto covered = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < columns && y < rows && cells[index(x, y)] != 0;
  };
  for (const auto* list : {&tiles, &holes}) {
    for (const Tile& tile : *list) {
      for (int y = place(ys, tile.low.y()); y < place(ys, tile.high.y()); ++y) {
        for (int x = place(xs, tile.low.x()); x < place(xs, tile.high.x()); ++x) {
          cells[index(x, y)] = list == &tiles ? 1 : 0;
        }
      }
    }
  }
  std::map<Cell, Cell> sides;  // what is covered lies to the left
  std::size_t count = 0;
  const auto side = [&](Cell from, Cell to) { ++count, sides.emplace(from, to); };
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      if (!covered(x, y)) continue;
      if (!covered(x, y - 1)) side({x, y}, {x + 1, y});
      if (!covered(x + 1, y)) side({x + 1, y}, {x + 1, y + 1});
      if (!covered(x, y + 1)) side({x + 1, y + 1}, {x, y + 1});
      if (!covered(x - 1, y)) side({x, y + 1}, {x, y});
    }
  }
  const std::vector<Cell> loop = loop_of(sides, count);
  if (loop.empty()) return std::nullopt;
  std::vector<Vec2> outline;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto [x, y] = loop[i];
    const auto [x0, y0] = loop[(i + loop.size() - 1) % loop.size()];
    const auto [x1, y1] = loop[(i + 1) % loop.size()];
    const bool straight = (x0 == x && x == x1) || (y0 == y && y == y1);
    if (!straight) outline.emplace_back(xs[static_cast<std::size_t>(x)], ys[static_cast<std::size_t>(y)]);
  }
  return outline;
}

std::vector<Tile> tiles_of(const std::vector<Vec2>& polygon) {
  std::vector<double> xs, ys;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    if (polygon[i].x() != polygon[j].x() && polygon[i].y() != polygon[j].y()) return {};
    xs.push_back(polygon[i].x());
    ys.push_back(polygon[i].y());
  }
  xs = lines_of(std::move(xs)), ys = lines_of(std::move(ys));
  std::vector<Tile> tiles;
  for (std::size_t y = 0; y + 1 < ys.size(); ++y) {
    bool open = false;  // the last tile goes on
    for (std::size_t x = 0; x + 1 < xs.size(); ++x) {
      const bool in = contains(polygon, {(xs[x] + xs[x + 1]) / 2, (ys[y] + ys[y + 1]) / 2});
      if (in && open) tiles.back().high.x() = xs[x + 1];
      if (in && !open) tiles.push_back({{xs[x], ys[y]}, {xs[x + 1], ys[y + 1]}});
      open = in;
    }
  }
  return tiles;
}

Opening opening_in(const std::vector<Vec2>& polygon, const Tile& doorway) {
  Opening opening;
  const Vec2 center = (doorway.low + doorway.high) / 2, half = (doorway.high - doorway.low) / 2;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2 side = polygon[i] - polygon[j];
    const double length = side.norm();
    if (!(length > 1e-9)) continue;
    const Vec2 along = side / length;
    const double at = std::clamp((center - polygon[j]).dot(along), 0.0, length);
    const double distance = (polygon[j] + along * at - center).norm();
    if (!(distance < nearest)) continue;
    nearest = distance;
    const double reach = half.dot(along.cwiseAbs());
    const Vec2 middle = polygon[j] + along * (center - polygon[j]).dot(along);
    opening.from = middle - along * reach;
    opening.to = middle + along * reach;
  }
  return opening;
}

}  // namespace unietp
