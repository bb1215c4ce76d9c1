#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "simulation/digest.h"
#include "validator/problem.h"

namespace unietp {

/// The problems of a data set in the order in which they were found: the first kKept of each kind, and how many there
/// are of each. So a report is bounded however much is wrong.
class ProblemList {
 public:
  static constexpr std::size_t kKept = 1000;

  void add(Problem problem);  // kept while there are fewer than kKept, counted always
  void add(std::vector<Problem> problems);
  /// Those of another list behind these.
  void add(ProblemList other);

  const std::vector<Problem>& kept() const { return kept_; }  // in the order of adding
  std::vector<Problem> take() { return std::move(kept_); }
  std::int64_t count(ProblemKind kind) const { return counts_[static_cast<std::size_t>(kind)]; }  // kept or not
  /// Whether a problem, kept or not, names this task.
  bool blames(std::string_view task) const { return tasks_.contains(key_of(task)); }

 private:
  static Digest key_of(std::string_view task) { return Digester().add(task).digest(); }

  std::vector<Problem> kept_;
  std::array<std::int64_t, kProblemKinds> counts_{};
  std::unordered_set<Digest, DigestHash> tasks_;  // never iterated into output
};

}  // namespace unietp
