#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/result.h"
#include "resources/resources.h"
#include "scene/scene.h"

namespace unietp {

/// Files as they are, and for each folder all *.scene.json and *.scene.json.gz in it, in order of name. Errors: Usage
/// for a folder without any.
std::vector<std::filesystem::path> scene_files_of(const std::vector<std::filesystem::path>& paths,
                                                  std::vector<Error>& errors);

/// Homes that a run uses instead of making its own.
struct GivenScenes {
  std::vector<Scene> scenes;       // in order of id
  std::vector<std::string> names;  // of the same scenes: "<id> <sha256 of its JSON>", as the manifest records them
  std::vector<Error> errors;       // empty when sound; every problem of every file otherwise
};

/// Reads scene files (*.scene.json, *.scene.json.gz) and all of those in folders. Errors: Io, Parse and Schema of the
/// files; Usage for a folder without any, for an id that two files share, and for a category that the simulator's
/// knowledge base lacks.
GivenScenes read_given_scenes(const std::vector<std::filesystem::path>& paths, const std::vector<Backend>& backends);

/// The same, where a path that does not exist may be the id of a home of the benchmark, which is then made. Errors:
/// also Usage for what is neither, with the nearest id.
GivenScenes given_homes(const std::vector<std::filesystem::path>& paths_or_ids, const Resources& resources,
                        const DataFolders& folders);

/// For tasks that are to be done in the simulators themselves: scene files that were imported, the simulators' own
/// files of any format that can be imported, which are imported here, and folders of both. `models`: as
/// read_foreign_scenes takes them. Errors: as above, and those of reading and importing; Usage for a home without an
/// object of a simulator's own scene.
GivenScenes native_homes(const std::vector<std::filesystem::path>& paths, const std::filesystem::path& models,
                         const Resources& resources, const DataFolders& folders);

}  // namespace unietp
