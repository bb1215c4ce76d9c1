#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/result.h"
#include "grounding/home_faults.h"
#include "homes/home_files.h"
#include "interchange/import_scene.h"

namespace unietp {

/// What is wrong with a home, and what was done about it.
struct HomeDiagnosis {
  std::string id, file_format;  // "unietp-scene" for a scene file of ours
  std::filesystem::path file;
  Simulator simulator = Simulator::Ai2thor;
  std::size_t rooms = 0, objects = 0;    // of the home as it is now
  std::optional<ImportReport> imported;  // of a simulator's file: what is wrong with the file, and each repair
  std::vector<std::string> warnings;     // of its reader
  std::vector<HomeFinding> faults;       // of the home as it is now
};

/// Imports the home with physics, as `unietp scene import` does, if it is in a simulator's format, and checks the
/// result (faults_of). A scene file of ours is checked as it is. Errors: those of assemble.
Result<HomeDiagnosis> diagnose(const HomeInFile& home, const std::vector<Backend>& backends, const FormatFacts& facts);

/// One home of data/schemas/scene-doctor.schema.json.
nlohmann::ordered_json diagnosis_to_json(const HomeDiagnosis& diagnosis);
/// The same for people: a line for the home, and for each kind of fault or repair its number and at most `examples` of
/// its objects.
std::string diagnosis_text(const HomeDiagnosis& diagnosis, std::size_t examples);

}  // namespace unietp
