#include "record/recorded_words.h"

#include <algorithm>
#include <array>

namespace unietp {
namespace {

/// The value of an enumeration whose names these are, in its order.
template <class Word>
std::optional<Word> named(std::string_view name, const std::array<std::string_view, 3>& names) {
  const auto* const found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? std::nullopt : std::optional(static_cast<Word>(found - names.begin()));
}

}  // namespace

std::optional<RecordedGrade> recorded_grade(std::string_view name) {
  return named<RecordedGrade>(name, {"senseless", "tolerable", "usual"});
}

std::optional<RecordedGrade> least_grade(std::string_view sense) {
  return named<RecordedGrade>(sense, {"any", "tolerable", "usual"});
}

std::optional<RecordedHomes> recorded_homes(std::string_view name) {
  return named<RecordedHomes>(name, {"drawn", "benchmark", "training"});
}

}  // namespace unietp
