#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace unietp {

/// What can be wrong with a data set; the name of a kind is part of the validator's output.
enum class ProblemKind : std::uint8_t {
  // the folder as a whole
  Manifest,
  OtherKnowledge,
  OtherVersion,
  MissingFile,
  UnlistedFile,
  ChangedFile,
  Counts,
  Quota,
  Balance,
  Rejections,
  Database,
  Card,
  Sources,
  Benchmark,
  Reviews,
  HomeFile,
  // of tasks among themselves, and against another folder
  RepeatedTask,
  RepeatedStart,
  RepeatedText,
  SharedLayout,
  SharedSeed,
  SimilarHome,
  SimilarTask,
  // a line or a scene
  Unreadable,
  TaskName,
  MissingDemonstration,
  StrayDemonstration,
  StepCount,
  // the start
  SceneName,
  Unbuildable,
  Relations,
  Unrest,
  StartConstraint,
  Edits,
  Forms,
  // the goal
  GoalText,
  GoalTree,
  Sense,
  BoundCategory,
  OfTemplate,
  GoalAtStart,
  PartAtStart,
  EmptyDomain,
  NoReferent,
  NoDistractor,
  NotNearest,
  // a demonstration
  Outcome,
  View,
  Changes,
  AfterEnd,
  NoStop,
  GoalNotReached,
  NeedlessStep,
  LeftInHand,
  AnyOrder,
  DistractorServes,
  SearchMark,
  TidyingMark,
  ShortestPlan,
  TemptingPlan,
  // an instruction
  NoText,
  TextForm,
  TextMeaning,
  TextStyle,
  TextPhrasing,
  TextRecord,
  TextUnchecked,
  Wordings,
};
inline constexpr std::size_t kProblemKinds = static_cast<std::size_t>(ProblemKind::Wordings) + 1;

/// A row of the table of problems.
struct ProblemInfo {
  ProblemKind kind;
  std::string_view name;     // "goal-at-start"
  std::string_view meaning;  // one line for people
};
/// All kinds, in the order of the enum.
std::span<const ProblemInfo> all_problems();
std::string_view name_of(ProblemKind kind);

/// Something wrong with a data set: with one task, or (task "") with the folder as a whole.
struct Problem {
  ProblemKind kind = ProblemKind::Manifest;
  std::string task;
  Error error;  // file, line where there is one, and why
  bool operator==(const Problem&) const = default;
};
/// One of no task yet, about a file.
Problem problem_in(ProblemKind kind, std::string where, std::string message);

/// `from` behind `to`.
void append(std::vector<Problem>& to, std::vector<Problem> from);

}  // namespace unietp
