#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "interchange/format_facts.h"
#include "interchange/import_scene.h"
#include "interchange/source_scene.h"
#include "tests/support/committed_knowledge.h"

namespace unietp::testing {

/// Folder of the simulators' own files; tests on them are skipped where it is missing.
std::filesystem::path upstream();

/// The committed profile of one simulator; loaded once a process.
const Profile& profile_of(Simulator simulator);

/// The committed facts about scene files; loaded once a process.
const FormatFacts& format_facts();

/// What became of one scene of a file.
struct Imported {
  std::string scene;
  ImportReport report;
  std::size_t restless = 0;  // number of objects that are not at rest
};

/// Assembles every `stride`-th scene, beginning with the first.
std::vector<Imported> import_all(const std::vector<SourceScene>& scenes, std::size_t stride);

/// "procthor: 100 files, 4,803 objects, …" and the worst files, with the issues counted by reason.
std::string table_row(const std::string& format, const std::vector<Imported>& all);

/// Shares of one file, 1 where there is nothing to count.
double arrived_share(const ImportReport& report);
double held_share(const ImportReport& report);
double loose_share(const ImportReport& report);

/// Objects of a scene that move by more than 5 mm in two seconds of physics.
std::vector<std::string> restless(const Scene& scene);

}  // namespace unietp::testing
