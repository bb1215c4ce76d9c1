#pragma once

#include <optional>
#include <string>

namespace unietp {

/// Seconds that a Retry-After header asks for, >= 0: its number, or its date less the answer's own Date header (the
/// clock when that is missing). Nothing when it does not read.
std::optional<double> retry_after_s(const std::string& retry_after, const std::string& date);

}  // namespace unietp
