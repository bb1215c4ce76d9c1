#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "templates/template.h"

namespace unietp {

/// A template file that may or may not be sound.
struct TemplateFile {
  std::string path;     // as errors name it
  std::string text;     // its bytes
  std::string library;  // "library", "extended", or "own" for one of a user's folder
  bool operator==(const TemplateFile&) const = default;
};

/// Errors: Io for a folder that cannot be listed and a file that cannot be read.
struct TemplateFiles {
  std::vector<TemplateFile> files;  // in order of path
  std::vector<Error> errors;
};
/// All `*.template` files below a folder; `place` alone when it is a file.
TemplateFiles template_files(const std::filesystem::path& place, const std::string& library);

/// Every file parsed, in the order given; a file with an error is refused and the rest are still read.
/// Errors: those of parse_template; Schema for a name that an earlier file has, naming both.
TemplateReading parse_files(const std::vector<TemplateFile>& files);

/// Puts the files into a compiled knowledge base (`unietp knowledge build`) as the table `template`, beside what it
/// holds: name, class, simulators, parameters and title for people, and the text that stages read. What cannot be
/// parsed is stored too, so that reading it from there tells the same errors. Paths are stored below `root`.
/// Errors: Io with SQLite's message.
Result<Done> store_templates(const std::filesystem::path& database, const std::filesystem::path& root,
                             const std::vector<TemplateFile>& files);

/// The files as they were stored, in the same order, their paths below `root` again. Errors: Schema when the file holds
/// no templates.
Result<std::vector<TemplateFile>> stored_templates(const std::filesystem::path& database,
                                                   const std::filesystem::path& root);

/// SHA-256 over libraries, paths below `root` and texts, in the order given.
std::string digest_of(const std::vector<TemplateFile>& files, const std::filesystem::path& root);

}  // namespace unietp
