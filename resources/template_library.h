#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "resources/data_folders.h"
#include "templates/template_files.h"

namespace unietp {

/// The files of the default library and of the extended one, which need not exist. Errors: Io.
TemplateFiles built_in_templates(const DataFolders& folders);

/// The templates that a command works with: the default library, the extended one when `folders` ask for it, and the
/// user's own, which are read from their files each time.
struct LibraryReading {
  std::vector<Template> templates;
  std::vector<std::string> own;  // of the user's: "<name> <sha256 of its file>"
  std::vector<Error> errors;     // of parse_files; Usage for a folder of the user's that does not exist
};
/// From the files.
LibraryReading library_of(const DataFolders& folders);
/// The built-in ones from a compiled knowledge base: equal to library_of when that was compiled from these folders.
LibraryReading library_in(const std::filesystem::path& database, const DataFolders& folders);

}  // namespace unietp
