#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "interchange/import_scene.h"
#include "interchange/source_scene.h"
#include "resources/resources.h"

namespace unietp {

/// The format of a scene file by the fields that only it has: one of scene_format_names(). nullopt: none of them.
std::optional<std::string> scene_format_of(std::string_view text);

/// One home of a simulator's own file, with an id that is a file's name and that no other home of the reading has.
struct ForeignHome {
  std::filesystem::path file;
  std::string format;  // of scene_format_names()
  SourceScene source;
};

struct ForeignReading {
  std::vector<ForeignHome> homes;  // in order of the files
  std::vector<Error> errors;       // empty when every file could be read
};

/// Reads the simulators' own scene files; plain or .gz, one home or several each. `format` is of scene_format_names(),
/// or "auto" for what the file shows. `models`, when not empty, is a file with the categories and sizes of models that
/// the scenes of Habitat and BEHAVIOR only name: for BEHAVIOR its inventory, for Habitat a table as read_scene_models
/// takes it. Errors, of all files: Usage for an unknown format and a file without a home; those of read_maybe_gzip and
/// of the format's reader.
ForeignReading read_foreign_scenes(const std::string& format, const std::vector<std::filesystem::path>& files,
                                   const std::vector<Backend>& backends, const std::filesystem::path& models = {});

/// assemble with the home's own backend.
Result<ImportedScene> import_home(const ForeignHome& home, const std::vector<Backend>& backends,
                                  const ImportOptions& options);

}  // namespace unietp
