#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "annotator/noun_table.h"
#include "core/result.h"
#include "grounding/layout.h"
#include "grounding/layout_library.h"
#include "resources/data_folders.h"
#include "simulation/profile.h"
#include "templates/template.h"

namespace unietp {

/// A simulator as the stages see it: what is known of its categories and how it limits its agent.
struct Backend {
  Knowledge knowledge;
  Profile profile;
  NounTable nouns;  // of the knowledge base
};

/// The database that the tables and the built-in templates compile to, made when the cache lacks it. Safe when several
/// processes start at once. Templates with errors are in it too: who reads them from there is told.
/// Errors: those of compile_knowledge, all of them; Io when the cache folder cannot be written.
struct CompiledKnowledge {
  std::filesystem::path database;
  std::vector<Error> errors;  // empty when sound
};
CompiledKnowledge compiled_knowledge(const DataFolders& folders);

/// The four backends in the order of kSimulators; with the extended library their agents act by the profile `wide`.
/// Errors: as above, and those of the profiles.
struct BackendsReading {
  std::vector<Backend> backends;
  std::filesystem::path database;  // that they were read from
  std::vector<Error> errors;
};
BackendsReading load_backends(const DataFolders& folders);

/// Everything that the stages read. Immutable; shared by all threads.
struct Resources {
  std::vector<Backend> backends;           // in the order of kSimulators
  std::vector<LayoutRecipe> recipes;       // likewise
  std::vector<Template> templates;         // the library's, the extended ones, the user's; each in order of file name
  std::vector<std::string> own;            // of the user's: "<name> <sha256 of its file>", as the manifest records them
  std::vector<BenchmarkLayout> benchmark;  // what the benchmark's homes are made from
  std::vector<Scene> homes;                // that a run is to use (given_scenes.h); empty: it draws its own
  std::string digest;                      // knowledge_digest of the folders

  const Backend& backend(Simulator simulator) const { return backends[static_cast<std::size_t>(simulator)]; }
  const LayoutRecipe& recipe(Simulator simulator) const { return recipes[static_cast<std::size_t>(simulator)]; }
};

struct ResourcesReading {
  Resources resources;
  std::vector<Error> errors;  // empty when sound; every problem of every file otherwise
};
ResourcesReading load_resources(const DataFolders& folders);

/// SHA-256 over the names and bytes of tables, profiles, layout recipes and built-in templates, in order of path, and
/// of the override files. A user's templates are named by the configuration: a data set made of them is proven without.
/// Errors: Io.
Result<std::string> knowledge_digest(const DataFolders& folders);

/// A category that a template names itself (not through a placeholder) must be known to one of its simulators.
/// Errors: Schema at the name's place in the template's file.
std::vector<Error> unknown_categories(const Template& source, const std::vector<Backend>& backends);

}  // namespace unietp
