#pragma once

#include <span>
#include <string_view>

namespace unietp {

/// A frame without a door that AI2-THOR puts into a gap in a wall.
struct DoorModel {
  std::string_view name;
  double width, height;  // metres
};

/// The frames of ProcTHOR's asset database, whose type is not among iTHOR's 125 and so not in the knowledge base.
/// Source: metadata:procthor_asset_database.json.gz (Apache-2.0).
std::span<const DoorModel> door_models();

/// The one nearest in width; ties go to the first.
const DoorModel& door_model_for(double width);

}  // namespace unietp
