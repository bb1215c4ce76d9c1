#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace unietp {

struct ManifestCheck {
  int tasks = -1;             // that the manifest counts; -1 when it cannot be read
  std::vector<Error> errors;  // each names its file
};

/// Reads manifest.json and holds every file of the folder against its length and SHA-256; a file that is missing, or
/// there without being listed, is an error too. `knowledge_digest` is what the manifest should name.
ManifestCheck check_manifest(const std::filesystem::path& folder, std::string_view knowledge_digest);

}  // namespace unietp
