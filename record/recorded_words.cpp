#include "record/recorded_words.h"

#include <algorithm>
#include <array>

namespace unietp {
namespace {

/// The value of an enumeration whose names these are, in its order.
template <class Word, std::size_t kCount>
std::optional<Word> named(std::string_view name, const std::array<std::string_view, kCount>& names) {
  const auto* const found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? std::nullopt : std::optional(static_cast<Word>(found - names.begin()));
}

}  // namespace

std::optional<RecordedGrade> recorded_grade(std::string_view name) {
  return named<RecordedGrade, 3>(name, {"senseless", "tolerable", "usual"});
}

std::optional<RecordedGrade> least_grade(std::string_view sense) {
  return named<RecordedGrade, 3>(sense, {"any", "tolerable", "usual"});
}

std::optional<RecordedHomes> recorded_homes(std::string_view name) {
  return named<RecordedHomes, 3>(name, {"drawn", "benchmark", "training"});
}

std::optional<RecordedSplit> recorded_split(std::string_view name) {
  return named<RecordedSplit, 5>(name, {"atomic", "compositional", "logical", "instance_grounding", "linguistic"});
}

}  // namespace unietp
