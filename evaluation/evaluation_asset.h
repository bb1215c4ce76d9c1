#pragma once

#include <string_view>

namespace unietp {

/// A file of evaluation/assets/, which the build put into the program, by file name. "" for any other.
std::string_view evaluation_asset(std::string_view name);

}  // namespace unietp
