#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/result.h"
#include "scene/archetype.h"
#include "scene/simulator.h"
#include "shapes/family.h"

namespace unietp {

struct ShapeLibraryReading;

/// The families of shapes, and which category has which: data/shapes/*.shapes and categories.csv (docs/shapes.md).
class ShapeLibrary {
 public:
  /// A text and the name of its file.
  struct File {
    std::string name, text;
  };

  /// In the order of the files.
  const std::vector<ShapeFamily>& families() const { return families_; }
  /// nullptr when there is no such family.
  const ShapeFamily* find(std::string_view name) const;
  /// nullptr for a category that is shown as its archetype. A row for exactly this category comes first, then
  /// that of its whole name, of the longest beginning of it, of the longest end, in words, and of its archetype.
  const ShapeFamily* family_of(Simulator simulator, std::string_view category, Archetype archetype) const;

 private:
  friend ShapeLibraryReading read_shape_library(const std::vector<File>& files, const File& categories);
  using Rows = std::unordered_map<std::string, std::size_t>;  // family by words; SIZE_MAX: the archetype
  static constexpr std::size_t kArchetype = static_cast<std::size_t>(-1);

  std::vector<ShapeFamily> families_;
  Rows exact_, begins_, ends_, archetypes_;  // exact_: "ai2thor Mug"
};

/// Errors: Parse and Schema with file, line and column; all of them.
struct ShapeLibraryReading {
  ShapeLibrary library;
  std::vector<Error> errors;
};
/// Families from their files, and the rows of `categories`.
ShapeLibraryReading read_shape_library(const std::vector<ShapeLibrary::File>& files,
                                       const ShapeLibrary::File& categories);
/// Of a folder. Errors: also Io.
ShapeLibraryReading load_shape_library(const std::filesystem::path& folder);

/// That of data/shapes when the program was built. Thread-safe; made at the first call.
const ShapeLibrary& built_in_shapes();

/// "coffee mug" of CoffeeMug and coffee_mug: lower case, words apart where the name shows them.
std::string words_of_category(std::string_view category);

}  // namespace unietp
