#pragma once

#include <filesystem>

#include "akb/tables.h"
#include "core/result.h"
#include "scene/simulator.h"

namespace unietp {

// Each importer reads the real metadata of one simulator below `upstream` and our own tables below `curated`
// (data/akb/curated), and gives the simulator's five tables. Deterministic. Errors: Io, Parse or Schema, naming the
// file.
Result<Tables> import_ai2thor(const std::filesystem::path& upstream, const std::filesystem::path& curated);
Result<Tables> import_virtualhome(const std::filesystem::path& upstream, const std::filesystem::path& curated);
Result<Tables> import_habitat(const std::filesystem::path& upstream, const std::filesystem::path& curated);
Result<Tables> import_behavior(const std::filesystem::path& upstream, const std::filesystem::path& curated);
/// The importer of one simulator.
Result<Tables> import_simulator(Simulator simulator, const std::filesystem::path& upstream,
                                const std::filesystem::path& curated);

/// Imports all four with `<tables>/curated` and writes `<tables>/<simulator>/*.csv`; nothing is written when one fails.
Result<Done> import_all(const std::filesystem::path& upstream, const std::filesystem::path& tables);

}  // namespace unietp
