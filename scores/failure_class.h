#pragma once

#include <optional>
#include <string>
#include <vector>

#include "environment/task.h"
#include "evaluation/episode_record.h"
#include "scores/replayed_episode.h"

namespace unietp {

/// Why an episode did not reach its goal. The order is that of the rules: the first that fits is the class of the
/// episode (docs/results.md has each rule).
enum class FailureGroup : std::uint8_t { Errored, Output, Stop, Limit, Exploration, Grounding, Precondition, Goal };
std::string_view name_of(FailureGroup group);  // "errored"

/// Why an episode did not succeed.
struct FailureClass {
  FailureGroup group = FailureGroup::Goal;
  std::string kind;  // "truncated"; of a precondition the name of the failure: "too_far"
  bool operator==(const FailureClass&) const = default;
};
std::string to_text(const FailureClass& failure);  // "output: truncated"
/// The reverse. nullopt for an unknown group or an empty kind.
std::optional<FailureClass> failure_class_of(std::string_view text);

/// What was wrong with an action as output; nullopt for an action that the world or the rules of naming judged.
/// `step`: of the record, whose reply it was.
enum class OutputFault : std::uint8_t { NoJson, UnknownAction, BadArgument, Truncated };
std::string_view name_of(OutputFault fault);  // "no_json"
std::optional<OutputFault> output_fault(const EpisodeStep& step, const EpisodeAction& action);

/// All classes that fit an episode but for premature_stop, in the order of the rules; empty for a success, at least one
/// otherwise. Depends on the episode and its task only.
std::vector<FailureClass> failure_classes(const EpisodeRecord& record, const ReplayedEpisode& replayed,
                                          const EnvironmentTask& task);

/// The class of an episode whose agent said `stop` too early, which other episodes have a say in.
FailureClass premature_stop();

/// Successful actions, `stop` among them.
int successful_actions(const ReplayedEpisode& replayed);
/// Whether that is too few for a `stop` without the goal: fewer than half of the steps of the shortest known plan,
/// which has a `stop`, too; none but `stop` where no plan is known.
bool too_early(int successful_actions, std::optional<int> shortest);
/// Whether the goal was reached and the agent never said `stop`.
bool missed_stop(const EpisodeRecord& record, const ReplayedEpisode& replayed);

}  // namespace unietp
