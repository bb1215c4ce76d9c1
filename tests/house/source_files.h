#pragma once

#include <filesystem>
#include <set>
#include <vector>

namespace unietp {

/// The files with one of these extensions in the rooms, the tests, the benchmarks and the Python package.
std::vector<std::filesystem::path> source_files(const std::set<std::filesystem::path>& extensions);

}  // namespace unietp
