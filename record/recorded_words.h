#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

// Words of finished data sets that decide what is checked. They are tables of their own: who writes a data set is above
// this room, and a word that is none of these is left to the checks, so the records keep texts.
namespace unietp {

/// How much sense a task makes (docs/sense.md), the least first.
enum class RecordedGrade : std::uint8_t { Senseless, Tolerable, Usual };
std::optional<RecordedGrade> recorded_grade(std::string_view name);  // "senseless", "tolerable", "usual"
/// The least grade that a run asks for, by its field `sense`: "any", "tolerable", "usual".
std::optional<RecordedGrade> least_grade(std::string_view sense);

/// Which homes a run takes, by its field `homes`.
enum class RecordedHomes : std::uint8_t { Drawn, Benchmark, Training };
std::optional<RecordedHomes> recorded_homes(std::string_view name);  // "drawn", "benchmark", "training"

/// What a task's field `split` says that it tests.
enum class RecordedSplit : std::uint8_t { Atomic, Compositional, Logical, InstanceGrounding, Linguistic };
std::optional<RecordedSplit> recorded_split(std::string_view name);  // "instance_grounding"

}  // namespace unietp
