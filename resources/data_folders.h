#pragma once

#include <filesystem>
#include <vector>

namespace unietp {

/// The program's data: a checkout, an installation's share/unietp, or a copy of its `data/` and `templates/` folders.
struct DataFolders {
  std::filesystem::path root;                         // holds data/ and templates/library/
  std::filesystem::path cache;                        // for compiled knowledge, in files named by digest
  std::vector<std::filesystem::path> overrides = {};  // the user's own facts, which win over data/akb/override.csv
  std::vector<std::filesystem::path> templates = {};  // the user's own, files or folders, beside the built-in ones
  bool extended_library = false;                      // use the extended templates too

  std::filesystem::path tables() const { return root / "data" / "akb"; }               // of the knowledge bases
  std::filesystem::path profiles() const { return root / "data" / "simulators"; }      // of agents
  std::filesystem::path sense() const { return root / "data" / "sense"; }              // what is usual in homes
  std::filesystem::path runs() const { return root / "data" / "runs"; }                // configurations of runs
  std::filesystem::path layouts() const { return root / "data" / "layouts"; }          // recipes of homes
  std::filesystem::path bddl() const { return root / "data" / "bddl"; }                // exports/bddl.h
  std::filesystem::path scene_files() const { return root / "data" / "scene_files"; }  // interchange/format_facts.h
  std::filesystem::path english() const { return root / "data" / "english"; }  // names, and report/word_figures.h
  std::filesystem::path benchmarks() const {
    return root / "data" / "benchmarks.csv";
  }  // resources/frozen_benchmarks.h
  std::filesystem::path licenses() const { return root / "data" / "licences.csv"; }
  std::filesystem::path library() const { return root / "templates" / "library"; }
  std::filesystem::path extended() const { return root / "templates" / "extended"; }  // need not exist
  std::filesystem::path compiled() const { return root / "compiled"; }                // as installed; need not exist
};

}  // namespace unietp
