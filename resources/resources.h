#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "annotator/noun_table.h"
#include "core/result.h"
#include "grounding/layout.h"
#include "grounding/layout_library.h"
#include "resources/data_folders.h"
#include "resources/frozen_benchmarks.h"
#include "sense/goal_sketch.h"
#include "simulation/profile.h"
#include "templates/template.h"

namespace unietp {

/// The British names of a knowledge base, made when they are first asked for.
struct BritishNouns {
  std::once_flag made;
  std::optional<NounTable> nouns;
};

/// A simulator: the facts about its categories and the limits of its agent.
struct Backend {
  Knowledge knowledge;
  Profile profile;
  NounTable nouns;  // of the knowledge base, as Americans say them
  std::shared_ptr<BritishNouns> british = std::make_shared<BritishNouns>();

  /// The names of one English. May be called by several threads at once.
  const NounTable& nouns_in(English english) const;
};

/// Where the compiled tables are.
struct CompiledKnowledge {
  std::filesystem::path database;  // SQLite
  std::vector<Error> errors;       // empty when sound
};
/// The database of the tables and the built-in templates. Its file name holds the digest of both. It is taken from
/// `folders.compiled()`, which is only read, else from the cache, and compiled into the cache when neither has it. Safe
/// for several processes at once. A template with errors is stored as it is; they are reported when it is loaded.
/// Errors: those of compile_knowledge, all of them, and then Usage with the program's version and what to do, since
/// tables that do not read may have come with another version; Io when the cache folder cannot be written.
CompiledKnowledge compiled_knowledge(const DataFolders& folders);
/// The same, compiled into `folder` even when there is a database already.
CompiledKnowledge compile_knowledge_into(const std::filesystem::path& folder, const DataFolders& folders);

/// The four backends in the order of kSimulators; with the extended library their agents have the profile `wide`.
/// Errors: those of compiled_knowledge and of the profiles.
struct BackendsReading {
  std::vector<Backend> backends;
  std::filesystem::path database;  // that they were read from
  std::vector<Error> errors;
};
BackendsReading load_backends(const DataFolders& folders);

/// Everything that the stages of generation read. Immutable; shared by all threads.
struct Resources {
  std::vector<Backend> backends;      // in the order of kSimulators
  std::vector<LayoutRecipe> recipes;  // likewise
  std::vector<Template> templates;    // the library's, the extended ones, the user's; each in order of file name
  std::vector<std::string> own;       // of the user's: "<name> <sha256 of its file>", as the manifest records them
  std::shared_ptr<const SenseTables> sense;
  std::vector<PieceGrades> piece_grades;   // of the simulators, in their order
  std::vector<BenchmarkLayout> benchmark;  // what the benchmark's homes are made from
  std::vector<Scene> homes;                // for a run to use (given_scenes.h); empty: it makes its own
  std::string digest;                      // knowledge_digest of the folders
  FrozenBenchmarks frozen;                 // by which a data set knows that it is one of them

  /// Of one simulator.
  const Backend& backend(Simulator simulator) const { return backends[static_cast<std::size_t>(simulator)]; }
  const LayoutRecipe& recipe(Simulator simulator) const { return recipes[static_cast<std::size_t>(simulator)]; }
};

/// The resources, or what is wrong with their files.
struct ResourcesReading {
  Resources resources;
  std::vector<Error> errors;  // empty when sound; every problem of every file otherwise
};
ResourcesReading load_resources(const DataFolders& folders);

/// SHA-256 over the names and bytes of tables, profiles, layout recipes, built-in templates and the words of other
/// formats, in order of path, and of the override files. A user's own templates are not part of it; the configuration
/// of a data set records them. Errors: Io.
Result<std::string> knowledge_digest(const DataFolders& folders);

/// Checks that each category that a template names itself (not through a placeholder) is known to one of its
/// simulators, and each kind to some category. Errors: Schema at the name's place in the template's file.
std::vector<Error> unknown_categories(const Template& source, const std::vector<Backend>& backends);

}  // namespace unietp
