#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "record/task_record.h"
#include "scene/scene.h"
#include "validator/lazy_values.h"
#include "validator/likeness_of_homes.h"
#include "validator/likeness_of_tasks.h"

namespace unietp {

// From here on two homes, or two tasks, are a leak between data sets. docs/validate.md shows what they were fitted to.
inline constexpr double kCopiedHome = 0.4;
// A task is one that was copied when all three are reached.
inline constexpr double kSimilarHome = 0.2, kSimilarGoal = 0.8, kSimilarText = 0.8;

/// The homes and tasks of a finished data set, as far as others are compared with them: some 20 KB of a home, some 400
/// bytes of a task.
struct ComparedSet {
  struct Home {
    std::string name;
    std::shared_ptr<const HomeFingerprint> print;
  };
  struct Task {
    std::string name;
    std::size_t home = 0;  // place in `homes`
    GoalPrint goal;
    TextFingerprint text;
  };
  std::vector<Home> homes;
  std::vector<Task> tasks;
};

/// How alike two tasks are, each from 0 to 1: their homes, goals and texts.
struct TaskLikeness {
  double home = 0, goal = 0, text = 0;
  /// The least of the three, each in proportion to where it counts as similar: from 1 on one task is a copy.
  double nearness() const;
};

/// The most alike homes and tasks of another data set, by place.
struct Nearest {
  struct Task {
    std::size_t place = 0;
    TaskLikeness likeness;
  };
  std::size_t home_place = 0;
  double home = 0;
  Task by_goal, by_text, by_all;  // the most alike goal; the most alike text; the greatest nearness
};

/// Finds what is most alike in another data set. Ties go to what is more alike in the other respects, then to the first
/// place.
class NearestTasks {
 public:
  explicit NearestTasks(ComparedSet other);

  /// For one task of a set whose homes have names of their own. nullopt when the other set has no tasks. Thread-safe
  /// and deterministic. Time: linear in the other set's tasks; for a home that is asked for first, in its homes.
  std::optional<Nearest> of(const TaskRecord& task, const Scene& home) const;
  const ComparedSet& other() const { return other_; }

 private:
  ComparedSet other_;
  /// Of an own home with each of the others.
  using HomeLikenesses = std::vector<double>;
  std::unique_ptr<LazyValues<HomeLikenesses>> by_home_;  // by pointer: it has a mutex, and this moves
};

}  // namespace unietp
