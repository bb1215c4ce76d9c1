#pragma once

#include <nlohmann/json_fwd.hpp>

#include "logic/formula.h"

namespace unietp {

/// A formula as a tree, as docs/files.md says: {"op": "exists", "variable": "x", "domain": {...}, "body": {...}}.
/// The validator reads it with code of its own.
nlohmann::ordered_json formula_to_json(const Formula& formula);

}  // namespace unietp
