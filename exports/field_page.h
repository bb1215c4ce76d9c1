#pragma once

#include <filesystem>
#include <string>

#include "core/result.h"

namespace unietp {

/// docs/fields.md: every field of every file that data/schemas/ describes, with its type and meaning, in order of the
/// schemas' names. Deterministic. Errors: Io; Parse for a schema that is no JSON.
Result<std::string> field_page(const std::filesystem::path& schemas);

}  // namespace unietp
