#pragma once

#include <string_view>
#include <vector>

namespace unietp {

/// A file that the program contains (shapes/CMakeLists.txt).
struct BuiltInFile {
  std::string_view name, text;
};

/// The files of data/shapes: the families by name, then devices.csv and categories.csv.
std::vector<BuiltInFile> built_in_shape_files();

}  // namespace unietp
