#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "interchange/format_facts.h"
#include "interchange/formats.h"
#include "interchange/import_scene.h"
#include "interchange/source_scene.h"
#include "resources/resources.h"

namespace unietp {

/// The format of a scene file, detected by fields that only this format has; nullopt for none.
std::optional<SceneFormat> scene_format_of(std::string_view text);

/// One home of a simulator's file. Its id can be a file name and is unique among the homes that were read together.
struct ForeignHome {
  std::filesystem::path file;
  SceneFormat format;
  SourceScene source;
};

/// The homes of some files, and what could not be read.
struct ForeignReading {
  std::vector<ForeignHome> homes;  // in order of the files
  std::vector<Error> errors;       // empty when every file could be read
};

/// Reads the simulators' own scene files; plain or .gz, one home or several each. `format` is of scene_format_names(),
/// or "auto" to detect it for each file. `models`, when not empty, is a file with the categories and sizes of models
/// that scenes of Habitat and BEHAVIOR only name: the object inventory for BEHAVIOR, a table for read_scene_models for
/// Habitat. Errors, of all files: Usage for an unknown format and a file without a home; those of read_maybe_gzip and
/// of the format's reader.
ForeignReading read_foreign_scenes(const std::string& format, const std::vector<std::filesystem::path>& files,
                                   const std::vector<Backend>& backends, const FormatFacts& facts,
                                   const std::filesystem::path& models = {});

/// assemble with the home's own backend.
Result<ImportedScene> import_home(const ForeignHome& home, const std::vector<Backend>& backends,
                                  const FormatFacts& facts, const ImportOptions& options);

}  // namespace unietp
