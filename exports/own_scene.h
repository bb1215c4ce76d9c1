#pragma once

#include <optional>
#include <string>

#include "akb/knowledge.h"
#include "logic/formula.h"
#include "record/dataset_reader.h"

namespace unietp {

// Tasks in a simulator's own scenes (docs/native.md) ask for nothing that the simulator does not have.

/// Whether something of a home has an id of its simulator's own.
bool in_own_scene(const Scene& start);

/// The first predicate of a goal that the runner of a simulator (python/adapters) does not read from the simulator's
/// state; nullopt when it reads all. What a `:where` asks is settled by the start.
std::optional<Predicate> untold_in(Simulator simulator, const Formula& goal);

/// Why a task in one of its simulator's own scenes is beyond that simulator; "" when it is not, and for other homes: a
/// goal that VirtualHome's graph or Habitat does not tell, an action of M1 that Habitat does not have or OmniGibson has
/// no primitive for.
std::string beyond_own_simulator(const FinishedTask& task);

/// Whether AI2-THOR's and ProcTHOR's own files have a thing of one category on or in one of the other, or in the part
/// of it that holds things.
bool listed_in_ai2thor(const Knowledge& knowledge, const std::string& thing, const std::string& place);

/// What the start of a task in one of AI2-THOR's own scenes puts on or in something that has no such thing in
/// AI2-THOR's and ProcTHOR's own files; "" when there is none, and for other homes.
std::string unlisted_in_ai2thor(const FinishedTask& task, const Knowledge& knowledge);

}  // namespace unietp
