#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "core/result.h"

namespace unietp {

/// All models of ProcTHOR's asset database under their AI2-THOR type, with their boxes in their own frame (front at
/// -y). Errors: Io, Parse.
Result<std::vector<Asset>> read_procthor_assets(const std::filesystem::path& upstream);

/// Size and mass that one simulator's metadata gives for a thing of some name.
struct UpstreamSize {
  std::optional<Vec3> extents;  // full, any order of axes, meters
  std::optional<double> mass;   // kilograms
  std::string extents_source, mass_source;
};

/// Middle sizes and masses by English name ("alarm clock"), for simulators whose own files have none: AI2-THOR's types
/// (ProcTHOR's models, iTHOR's masses) and, for what they lack, BEHAVIOR's categories. Errors: Io, Parse.
Result<std::map<std::string, UpstreamSize>> read_upstream_sizes(const std::filesystem::path& upstream);

}  // namespace unietp
