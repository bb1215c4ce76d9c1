#include <cassert>

#include "shapes/built_in_files.h"
#include "shapes/library.h"

namespace unietp {

const ShapeLibrary& built_in_shapes() {
  static const ShapeLibrary library = [] {
    std::vector<ShapeLibrary::File> files;
    for (const BuiltInFile& file : built_in_shape_files())
      files.push_back({std::string(file.name), std::string(file.text)});
    const ShapeLibrary::File categories = files.back();
    files.pop_back();
    auto reading = read_shape_library(files, categories);
    assert(reading.errors.empty());  // a test reads them
    return std::move(reading.library);
  }();
  return library;
}

}  // namespace unietp
