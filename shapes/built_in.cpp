#include <cassert>
#include <utility>

#include "shapes/built_in_files.h"
#include "shapes/device.h"
#include "shapes/library.h"

namespace unietp {
namespace {

/// The built-in files: those of families, and the two tables.
struct BuiltIn {
  std::vector<ShapeLibrary::File> families;
  ShapeLibrary::File devices, categories;
};

BuiltIn built_in() {
  BuiltIn files;
  for (const BuiltInFile& file : built_in_shape_files())
    files.families.push_back({std::string(file.name), std::string(file.text)});
  for (ShapeLibrary::File* const table : {&files.categories, &files.devices}) {
    *table = std::move(files.families.back());
    files.families.pop_back();
  }
  return files;
}

}  // namespace

const ShapeLibrary& built_in_shapes() {
  static const ShapeLibrary library = [] {
    const BuiltIn files = built_in();
    auto reading = read_shape_library(files.families, files.categories);
    assert(reading.errors.empty());  // a test reads them
    return std::move(reading.library);
  }();
  return library;
}

const std::vector<DeviceRow>& built_in_devices() {
  static const std::vector<DeviceRow> rows = [] {
    const BuiltIn files = built_in();
    auto table = read_devices(files.devices.name, files.devices.text);
    assert(table.errors.empty() && !table.rows.empty());  // a test reads them
    return std::move(table.rows);
  }();
  return rows;
}

}  // namespace unietp
