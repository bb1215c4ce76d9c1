#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "sense/grade_goal.h"

namespace unietp {

/// What people do with things, and what words for things mean: data/sense/.
struct SenseTables {
  CommonSense common;
  WordKinds words;
};

/// The grades of pieces of goals on one simulator, each worked out when it is first asked for: what people make of a
/// piece depends only on the kinds of its things, and there are far fewer kinds than categories. Remembering changes
/// no answer. Thread-safe; a copy shares what is remembered.
class PieceGrades {
 public:
  PieceGrades(const Knowledge& knowledge, std::shared_ptr<const SenseTables> tables);

  /// As grade_piece; Usual where that has no grade. `knowledge` equals the one that it was made from.
  Grade grade(const Wants& piece, const Knowledge& knowledge) const;

 private:
  struct Table;
  std::shared_ptr<Table> table_;
};

/// A goal with placeholders, ready to be graded for one binding after the other while they are drawn.
class GoalSketch {
 public:
  using Bound = std::pair<std::string, std::string>;  // placeholder, what it is bound to

  /// `placeholders` in the order in which they are bound. The knowledge must outlive it.
  GoalSketch(const Formula& goal, const std::vector<std::string>& placeholders, const PieceGrades& grades,
             const Knowledge& knowledge);

  /// The worst grade of the pieces that speak of `next` and otherwise of `bound` alone; Usual when there is none.
  /// The worst of all steps of a binding is the grade of the goal with it, but for a goal without any graded part.
  Grade grade_of_step(std::span<const Bound> bound, const Bound& next) const;

 private:
  struct Piece {
    Wants wants;
    std::vector<std::string> placeholders;  // that it speaks of
  };
  std::vector<Piece> pieces_;
  std::string first_;  // the placeholder with which pieces without any are graded
  PieceGrades grades_;
  const Knowledge* knowledge_;
};

}  // namespace unietp
