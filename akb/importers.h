#pragma once

#include <filesystem>

#include "akb/absurd_place.h"
#include "akb/tables.h"
#include "core/result.h"
#include "scene/simulator.h"

namespace unietp {

// Each importer reads the real metadata of one simulator below `upstream` and our own tables below `curated`
// (data/akb/curated), and gives the simulator's six tables without the placements that are absurd. Deterministic.
// Errors: Io, Parse or Schema, naming the file.
Result<Tables> import_ai2thor(const std::filesystem::path& upstream, const std::filesystem::path& curated,
                              const AbsurdPlace& absurd = {});
Result<Tables> import_virtualhome(const std::filesystem::path& upstream, const std::filesystem::path& curated,
                                  const AbsurdPlace& absurd = {});
Result<Tables> import_habitat(const std::filesystem::path& upstream, const std::filesystem::path& curated,
                              const AbsurdPlace& absurd = {});
Result<Tables> import_behavior(const std::filesystem::path& upstream, const std::filesystem::path& curated,
                               const AbsurdPlace& absurd = {});
/// The importer of one simulator.
Result<Tables> import_simulator(Simulator simulator, const std::filesystem::path& upstream,
                                const std::filesystem::path& curated, const AbsurdPlace& absurd = {});

/// Whether a placement of one of the simulators is absurd.
using AbsurdPlaceOf = std::function<AbsurdPlace(Simulator)>;

/// Imports all four with `<tables>/curated` and writes `<tables>/<simulator>/*.csv`; nothing is written when one fails.
Result<Done> import_all(const std::filesystem::path& upstream, const std::filesystem::path& tables,
                        const AbsurdPlaceOf& absurd);

}  // namespace unietp
