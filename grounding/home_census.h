#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/result.h"
#include "scene/scene.h"

namespace unietp {

/// One thing of a home as statistics see it.
struct CensusObject {
  std::string category;
  bool movable = false;
  std::optional<Bounds> box;         // in W, meters; none where the source has no poses
  std::vector<std::string> held_by;  // categories of what it is on or inside
};

/// A room and what is in it.
struct CensusRoom {
  std::string type;           // "kitchen"
  std::vector<Vec2> outline;  // empty where the source has no geometry
  std::vector<CensusObject> objects;
};

/// What one home holds, room by room: from a scene here, from a simulator's own file in layout_fit.
struct HomeCensus {
  std::vector<CensusRoom> rooms;
};

/// Names that a simulator counts as objects and a scene of ours has as its floor, walls and openings or as a part of
/// another object: they are left out of every census. "Floor" and "SinkBasin" are, "Sink" is not.
using StructureNames = std::set<std::string, std::less<>>;
/// Reads data/layouts/curated/structure.csv (name,source). Errors: Io; Parse.
Result<StructureNames> read_structure_names(const std::filesystem::path& path);

/// Structure and objects that lie in no room are left out.
HomeCensus census_of(const Scene& scene, const StructureNames& structure);

/// The share of a room's floor over which no thing stands low: a grid of 10 cm cells, minus those whose middle lies
/// under the box of a thing that begins below 0.5 m and is higher than 5 cm. nullopt without an outline.
std::optional<double> free_floor_share(const CensusRoom& room);
/// Square meters; 0 without an outline.
double floor_area(const CensusRoom& room);

}  // namespace unietp
