#pragma once

#include <nlohmann/json_fwd.hpp>

#include "validator/likeness_report.h"

namespace unietp {

/// An element of `likeness` in the output of `unietp validate --json`.
nlohmann::ordered_json likeness_json(const LikenessReport& report);

/// The same for people, to stdout: a table of the distributions, then the closest pairs.
void print_likeness(const LikenessReport& report);

}  // namespace unietp
