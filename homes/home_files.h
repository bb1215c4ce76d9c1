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

/// A home as read from a file: a scene in our format, or one in a simulator's format that is not converted yet.
struct HomeInFile {
  std::string id;
  std::variant<Scene, ForeignHome> content;
  std::filesystem::path file;
};

/// That of the scene, or of the format.
Simulator simulator_of(const HomeInFile& home);

/// The homes of some files and folders, and what could not be read.
struct HomesReading {
  std::vector<HomeInFile> homes;  // ours first, then the others; in order of the files
  std::vector<Error> errors;      // empty when every file could be read
};

/// Reads scene files, ours and the simulators' (whose format is detected), and all scene files
/// (*.scene.json, *.scene.json.gz) of folders. `models`: as read_foreign_scenes takes them. Errors: those of the
/// readers; Usage for a folder without any scene file, and for a file that is in no known format.
HomesReading read_homes(const std::vector<std::filesystem::path>& paths, const std::vector<Backend>& backends,
                        const FormatFacts& facts, const std::filesystem::path& models = {});

/// The home as a scene, with every object where its file places it. Errors: those of assemble.
Result<Scene> scene_of(const HomeInFile& home, const std::vector<Backend>& backends, const FormatFacts& facts);

}  // namespace unietp
