#pragma once

#include <string>
#include <string_view>

namespace unietp {

/// "0.1.0": the version that CMakeLists.txt gives the project.
std::string_view program_version();

/// "GNU 12.2.0, Release, commit 0123456789ab": compiler, build type and, where the sources were a git checkout when
/// CMake configured them, the commit. No date and no path, so equal sources give equal programs.
std::string_view program_build();

}  // namespace unietp
