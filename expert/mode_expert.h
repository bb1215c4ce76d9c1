#pragma once

#include <optional>

#include "expert/expert.h"

namespace unietp {

class Household;

/// A rejection based only on the goal, before any work on a start: the mode does not offer an action that every way to
/// meet the goal needs, such as `read` in M3, where what is held cannot be named. nullopt does not promise that the
/// mode can meet the goal. Reason `not-in-m2` or `not-in-m3`.
std::optional<Rejection> ruled_out_in(Mode mode, const Formula& goal);

/// What an agent of a mode, M2 or M3, does to reach the goal by what it can know there (belief_expert.h), with `stop`.
/// `usual`: where things usually are. Rejections: as demonstrate_in.
std::variant<std::vector<Action>, Rejection> act_by_belief(Mode mode, ExecutionTree& executions,
                                                           const Household* usual);

/// Stage: the same goal under the rules of another mode, M2 or M3, as act_by_belief does it. Kept only if the goal
/// holds on the executed trace within the limits of the mode. Steps that only served to see something are marked; the
/// plan of one who knows the whole home, with the actions that the mode offers, is kept beside it: that of `shown`, the
/// demonstration in M1, where it is one already. Deterministic. Rejections: stage `expert`, reason `not-in-m2` or
/// `not-in-m3`; the detail says what stood in the way. `done`: what act_by_belief gave here; empty: it is asked.
std::variant<Demonstration, Rejection> demonstrate_in(Mode mode, ExecutionTree& executions, const Demonstration& shown,
                                                      const Household* usual = nullptr, std::vector<Action> done = {});
std::variant<Demonstration, Rejection> demonstrate_in(Mode mode, const Formula& goal, const Scene& start,
                                                      const Knowledge& knowledge, const Profile& profile,
                                                      const Demonstration& shown);

}  // namespace unietp
