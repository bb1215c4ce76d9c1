#pragma once

#include <string>

namespace unietp {

/// What differs between the identities of two runs, which are JSON: a line for each value, "\n  /configuration/seed was
/// 3 and is 4", at most eight of them. Pure.
std::string run_differences(const std::string& was, const std::string& is);

}  // namespace unietp
