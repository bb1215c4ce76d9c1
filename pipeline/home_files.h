#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/result.h"
#include "pipeline/resources.h"
#include "scene/scene.h"

namespace unietp {

/// A home as a file has it.
struct HomeInFile {
  std::string id;
  Scene content;
};

Simulator simulator_of(const HomeInFile& home);

struct HomesReading {
  std::vector<HomeInFile> homes;  // in order of the files
  std::vector<Error> errors;      // empty when every file could be read
};

/// Reads scene files and all of those (*.scene.json, *.scene.json.gz) in folders. Errors: those of the readers; Usage
/// for a folder without any.
HomesReading read_homes(const std::vector<std::filesystem::path>& paths, const std::vector<Backend>& backends);

/// The home as a scene.
Result<Scene> scene_of(const HomeInFile& home, const std::vector<Backend>& backends);

}  // namespace unietp
