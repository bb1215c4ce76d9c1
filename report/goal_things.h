#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "record/dataset_reader.h"

namespace unietp {

/// What the goal of one task is about.
struct TaskGoalThings {
  std::set<std::string> categories;  // that variables of the goal range over
  /// Objects that the demonstration in M1 acts on and that are of these categories, and how many of them an edit of
  /// the start added to the home or moved there.
  int objects = 0, added = 0, moved = 0;
};
/// Deterministic. Nothing is counted of a task whose demonstration in M1 was not read.
TaskGoalThings goal_things_of(const FinishedTask& task);

/// What the goals of a data set are about, on one simulator.
struct GoalThings {
  static constexpr std::size_t kCommonest = 30;

  std::string simulator;
  int tasks = 0;
  int objects = 0, added = 0, moved = 0;  // summed over the tasks
  std::map<std::string, int> categories;  // tasks whose goal names it, by movable category
  std::map<std::string, int> templates;   // tasks
  std::set<std::string> named;            // every category that some goal names
  int movable = 0;                        // categories of the knowledge base that are carried about
  /// Of the movable categories that are commonest in the homes, at most kCommonest, those that no goal names.
  std::vector<std::string> common_unused;

  /// Counts one task.
  void add(const TaskGoalThings& task);
  /// Keeps the movable ones of the categories and compares them with what is in the homes: objects by category.
  void finish(const Knowledge& knowledge, const std::map<std::string, int>& in_homes);
  /// The category that the most goals name, the first by name of equals; "" when there is none.
  std::string most_named() const;
};

}  // namespace unietp
