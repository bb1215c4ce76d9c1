#include "simulation/board_surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/archetype_dimensions.h"

namespace unietp {
namespace {

constexpr double kLevel_m = 0.0005;     // upper faces that differ by less are one
constexpr double kSliver_m = 0.0035;    // gaps that cutting leaves where a piece was too thin to keep
constexpr double kLowest_m = 0.03;      // smallest clearance of a surface
constexpr std::size_t kMostLines = 80;  // of a level, each way; of more, each board is looked at alone

double top_of(const Board& board) { return board.center.z() + board.size.z() / 2; }

/// The upper faces of boards of one joint at one height, as a grid of cells between the edges of all boards that
/// matter.
class Level {
 public:
  Level(const std::vector<Board>& boards, std::size_t first) : z_(top_of(boards[first])), joint_(boards[first].joint) {
    for (const Board& board : boards) {
      const bool own = is_own(board);
      if (!own && (board.center.z() - board.size.z() / 2 <= z_ - kDoorGap_m || top_of(board) <= z_)) continue;
      const double in = own ? 0 : kDoorGap_m;  // what only touches from aside does not count as above
      for (const int axis : {0, 1}) {
        const double half = board.size[axis] / 2 - in;
        if (half <= 0) continue;
        lines_[axis].push_back(board.center[axis] - half);
        lines_[axis].push_back(board.center[axis] + half);
      }
    }
    for (auto& lines : lines_) {
      std::sort(lines.begin(), lines.end());
      lines.erase(std::unique(lines.begin(), lines.end(), [](double a, double b) { return b - a < 1e-6; }),
                  lines.end());
    }
    if (std::max(lines_[0].size(), lines_[1].size()) > kMostLines) return;
    clearance_.assign(columns() * rows(), -1);
    for (std::size_t y = 0; y < rows(); ++y) {
      for (std::size_t x = 0; x < columns(); ++x) clearance_[y * columns() + x] = clearance_at(boards, x, y);
    }
  }

  bool is_own(const Board& board) const { return board.joint == joint_ && std::abs(top_of(board) - z_) < kLevel_m; }

  /// False when there are too many edges to look at the boards together.
  bool is_simple() const { return !clearance_.empty(); }

  /// Every free cell lies in one of them; each is as long as can be, or as deep.
  void add_surfaces(std::vector<Surface>& surfaces) const {
    for (const double least : {kOpenAbove_m, 0.25, kLowest_m}) {
      std::vector<bool> done(clearance_.size(), false);
      for (std::size_t cell = 0; cell < clearance_.size(); ++cell) {
        // What was found with more room above is not looked for again.
        if (done[cell] || clearance_[cell] < least || is_sliver(cell % columns(), cell / columns())) continue;
        for (const bool x_first : {true, false}) {
          const Cells found = grown(cell, x_first, least);
          for (std::size_t y = found.y0; y <= found.y1; ++y) {
            for (std::size_t x = found.x0; x <= found.x1; ++x) done[y * columns() + x] = true;
          }
          add(found, surfaces);
        }
      }
    }
  }

 private:
  struct Cells {
    std::size_t x0, x1, y0, y1;
  };

  std::size_t columns() const { return lines_[0].empty() ? 0 : lines_[0].size() - 1; }
  std::size_t rows() const { return lines_[1].empty() ? 0 : lines_[1].size() - 1; }
  double width(int axis, std::size_t at) const { return lines_[axis][at + 1] - lines_[axis][at]; }
  bool is_sliver(std::size_t x, std::size_t y) const { return std::min(width(0, x), width(1, y)) < kSliver_m; }

  /// Free height over a cell; -1 where no board is below.
  double clearance_at(const std::vector<Board>& boards, std::size_t x, std::size_t y) const {
    const Vec2 middle(lines_[0][x] + width(0, x) / 2, lines_[1][y] + width(1, y) / 2);
    bool covered = is_sliver(x, y);
    double clearance = kOpenAbove_m;
    for (const Board& board : boards) {
      const Vec2 apart = (board.center.head<2>() - middle).cwiseAbs() - board.size.head<2>() / 2;
      if (is_own(board)) {
        covered = covered || apart.maxCoeff() < 0;
        continue;
      }
      const double bottom = board.center.z() - board.size.z() / 2;
      if (bottom > z_ - kDoorGap_m && top_of(board) > z_ && apart.maxCoeff() < -kDoorGap_m)
        clearance = std::min(clearance, std::max(0.0, bottom - z_));
    }
    return covered ? clearance : -1;
  }

  bool all_free(const Cells& cells, double least) const {
    for (std::size_t y = cells.y0; y <= cells.y1; ++y) {
      for (std::size_t x = cells.x0; x <= cells.x1; ++x) {
        if (clearance_[y * columns() + x] < least) return false;
      }
    }
    return true;
  }

  Cells grown(std::size_t cell, bool x_first, double least) const {
    const std::size_t x = cell % columns(), y = cell / columns();
    Cells cells{x, x, y, y};
    const auto along_x = [&] {
      while (cells.x0 > 0 && all_free({cells.x0 - 1, cells.x0 - 1, cells.y0, cells.y1}, least)) --cells.x0;
      while (cells.x1 + 1 < columns() && all_free({cells.x1 + 1, cells.x1 + 1, cells.y0, cells.y1}, least)) ++cells.x1;
    };
    const auto along_y = [&] {
      while (cells.y0 > 0 && all_free({cells.x0, cells.x1, cells.y0 - 1, cells.y0 - 1}, least)) --cells.y0;
      while (cells.y1 + 1 < rows() && all_free({cells.x0, cells.x1, cells.y1 + 1, cells.y1 + 1}, least)) ++cells.y1;
    };
    if (x_first) along_x();
    along_y();
    if (!x_first) along_x();
    return cells;
  }

  void add(const Cells& cells, std::vector<Surface>& surfaces) const {
    const Vec2 low(lines_[0][cells.x0], lines_[1][cells.y0]), high(lines_[0][cells.x1 + 1], lines_[1][cells.y1 + 1]);
    const Vec2 half = (high - low) / 2 - Vec2::Constant(kSurfaceEdge_m), middle = (low + high) / 2;
    if (half.minCoeff() <= 0) return;
    double clearance = kOpenAbove_m;
    for (std::size_t y = cells.y0; y <= cells.y1; ++y) {
      for (std::size_t x = cells.x0; x <= cells.x1; ++x) clearance = std::min(clearance, clearance_[y * columns() + x]);
    }
    const auto holds_it = [&](const Surface& other) {
      const Vec2 apart = (other.center.head<2>() - middle).cwiseAbs() + half - other.half;
      return other.joint == joint_ && std::abs(other.center.z() - z_) < kLevel_m && apart.maxCoeff() < 1e-6 &&
             other.clearance >= clearance;
    };
    if (std::any_of(surfaces.begin(), surfaces.end(), holds_it)) return;
    surfaces.push_back({Vec3(middle.x(), middle.y(), z_), half, clearance, joint_, -1});
  }

  double z_;
  int joint_;
  std::array<std::vector<double>, 2> lines_;
  std::vector<double> clearance_;  // of each cell, row by row; empty when there are too many
};

/// The surface on one board alone.
void add_alone(const std::vector<Board>& boards, const Board& board, std::vector<Surface>& surfaces) {
  const Vec2 half = board.size.head<2>() / 2 - Vec2::Constant(kSurfaceEdge_m);
  const Vec3 top = board.center + Vec3(0, 0, board.size.z() / 2);
  double clearance = kOpenAbove_m;
  for (const Board& other : boards) {
    if (&other == &board) continue;  // it may be thinner than the gap
    const double bottom = other.center.z() - other.size.z() / 2;
    const Vec2 apart = (other.center - top).head<2>().cwiseAbs() - (other.size + board.size).head<2>() / 2;
    if (bottom > top.z() - kDoorGap_m && apart.maxCoeff() < -kDoorGap_m)
      clearance = std::min(clearance, std::max(0.0, bottom - top.z()));
  }
  if (half.minCoeff() > 0 && clearance >= kLowest_m) surfaces.push_back({top, half, clearance, board.joint, -1});
}

}  // namespace

std::vector<Surface> surfaces_on(const std::vector<Board>& boards) {
  std::vector<Surface> surfaces;
  for (std::size_t i = 0; i < boards.size(); ++i) {
    const Level level(boards, i);
    const bool earlier = std::any_of(boards.begin(), boards.begin() + static_cast<std::ptrdiff_t>(i),
                                     [&](const Board& board) { return level.is_own(board); });
    if (!level.is_simple()) {
      add_alone(boards, boards[i], surfaces);
    } else if (!earlier) {
      level.add_surfaces(surfaces);
    }
  }
  return surfaces;
}

}  // namespace unietp
