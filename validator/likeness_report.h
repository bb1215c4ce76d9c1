#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "validator/nearest_tasks.h"

namespace unietp {

/// How alike a data set is to another one in one respect.
struct LikenessMeasure {
  /// An own home or task, and the most alike one of the other set.
  struct Pair {
    std::string own, other;
    double value = 0;
    std::optional<TaskLikeness> likeness;  // of tasks
  };
  std::string_view name;           // "homes", "goals", "texts", "tasks"
  std::optional<double> fails_at;  // a value from which on it is a leak; nullopt: alike in this alone is none
  std::vector<double> values;      // one per own home or task, of the most alike one; rising
  std::vector<Pair> closest;       // at most ten, the most alike first

  /// The value that a share of all values does not exceed; 0 when there are none.
  double quantile(double share) const;
};

/// How alike the homes and tasks of a data set are to the nearest ones of another (docs/validate.md).
struct LikenessReport {
  std::string folder;  // of the other set
  std::array<LikenessMeasure, 4> measures;
  /// Own tasks of which the other set has the instruction, too, but for case, punctuation and articles. Alone no leak.
  int shared_texts = 0;
};

/// Gathers what was found of one task after the other: 30 bytes of each.
class LikenessCount {
 public:
  explicit LikenessCount(std::string folder);
  /// `other`: what `nearest` has places in.
  void add(const TaskRecord& task, const Nearest& nearest, const ComparedSet& other);
  LikenessReport report() const;

 private:
  LikenessReport report_;
  std::set<std::string> homes_;  // that were counted
};

}  // namespace unietp
