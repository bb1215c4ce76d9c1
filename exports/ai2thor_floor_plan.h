#pragma once

#include <nlohmann/json_fwd.hpp>

#include "interchange/formats.h"
#include "record/dataset_reader.h"

namespace unietp {

// A home that is one of iTHOR's floor plans, with iTHOR's own ids: AI2-THOR loads it by its name, so no model of its
// furniture is needed.

/// Whether the home of a task is one: it has the name of one and an object with an id of AI2-THOR.
bool is_floor_plan(const FinishedTask& task);

/// What stands in the place of a house: `scene`, the name; `rooms` and the agent's `metadata` as a house has them. All
/// objects that the floor plan has keep their ids; what a task added is left out.
ExportedScene write_floor_plan(const FinishedTask& task);

/// The call that puts the objects of the floor plan that can move where they are at the start: SetObjectPoses, whose
/// `objectPoses` name `objectId`, `center` of the box and `rotation`, in Unity's frame and above the floor.
nlohmann::ordered_json floor_plan_poses(const Scene& start);

}  // namespace unietp
