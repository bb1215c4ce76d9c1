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
struct UnityClasses {
  UnityProperties table;       // upstream's table, which speaks of every class that Unity has
  UnityProperties apartments;  // what the graphs of Unity's own apartments have beyond it
};
/// Reads data/scene_files/virtualhome_unity.csv. Errors: Io; those of a table that is none.
Result<UnityClasses> read_unity_classes(const std::filesystem::path& file);

/// The first thing that a program asks of a class and the table denies, as a reason to refuse the task; "" where the
/// table allows the program. Source of what each action needs: VirtualHome's documentation of its Unity simulator.
std::string denied_by_unity(const std::vector<std::string>& program, const UnityClasses& classes);

}  // namespace unietp
