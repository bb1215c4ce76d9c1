#pragma once

#include <string_view>

namespace unietp {

/// A file that the build put into the program: those of report/assets/ and Chart.js, by file name. "" for any other.
std::string_view asset(std::string_view name);

}  // namespace unietp
