#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/result.h"

namespace unietp {

/// What an object of a class can do in VirtualHome's Unity simulator: its properties, "CAN_OPEN", by class.
using UnityProperties = std::map<std::string, std::set<std::string>>;
/// Reads data/scene_files/virtualhome_unity.csv: what upstream's table says of each class, and what the graphs that
/// Unity itself wrote of its apartments say beyond it. Errors: Io; those of a table that is none.
Result<UnityProperties> read_unity_properties(const std::filesystem::path& file);

/// The first thing that a program asks of a class that neither source allows, as a reason to refuse the task; ""
/// where there is none. Source of what each action needs: VirtualHome's documentation of its Unity simulator.
std::string denied_by_unity(const std::vector<std::string>& program, const UnityProperties& properties);

}  // namespace unietp
