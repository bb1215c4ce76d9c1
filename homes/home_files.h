#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "core/result.h"
#include "homes/foreign_scenes.h"
#include "resources/resources.h"
#include "scene/scene.h"

namespace unietp {

/// A home as a file has it: a scene of ours, or a simulator's own account that is still to be turned into one.
struct HomeInFile {
  std::string id;
  std::variant<Scene, ForeignHome> content;
};

Simulator simulator_of(const HomeInFile& home);

struct HomesReading {
  std::vector<HomeInFile> homes;  // ours first, then the others; in order of the files
  std::vector<Error> errors;      // empty when every file could be read
};

/// Reads scene files, ours and the simulators' own (their format is told from what they hold), and all scene files
/// (*.scene.json, *.scene.json.gz) of folders. Errors: those of the readers; Usage for a folder without any scene file,
/// and for a file that is in no known format.
HomesReading read_homes(const std::vector<std::filesystem::path>& paths, const std::vector<Backend>& backends);

/// The home as a scene, everything at the place that its file says. Errors: those of assemble.
Result<Scene> scene_of(const HomeInFile& home, const std::vector<Backend>& backends);

}  // namespace unietp
