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

/// All classes that fit an episode, in the order of the rules; empty for a success, at least one otherwise. Depends on
/// the episode and its task only. `shortest`: steps of the shortest known plan, `stop` included, if one is known.
std::vector<FailureClass> failure_classes(const EpisodeRecord& record, const ReplayedEpisode& replayed,
                                          const EnvironmentTask& task, std::optional<int> shortest);

/// Whether the agent said `stop` after fewer successful actions than half of the shortest known plan has, without the
/// goal; whether the goal was reached and the agent never said `stop`.
bool stopped_early(const EpisodeRecord& record, const ReplayedEpisode& replayed, std::optional<int> shortest);
bool missed_stop(const EpisodeRecord& record, const ReplayedEpisode& replayed);

}  // namespace unietp
