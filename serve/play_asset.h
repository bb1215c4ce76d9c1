#pragma once

#include <string_view>

namespace unietp {

/// A file of serve/assets/, which the build put into the program, by file name. "" for any other.
std::string_view play_asset(std::string_view name);

}  // namespace unietp
