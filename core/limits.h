#pragma once

#include <cstddef>
#include <cstdint>

/// The bounds that readers enforce on what they are given, each with its reason. What is beyond one is refused with an
/// error that names the bound, or counted in a report.
namespace unietp::limits {

// Text of any file. Readers of nested text are recursive, so its depth is bounded for the sake of the stack.
inline constexpr std::size_t kUnpackedBytes = std::size_t{1} << 30;  // of a gzip file: a small one may claim terabytes
inline constexpr int kFormulaDepth = 200;                            // brackets of a formula, clauses of a sentence
inline constexpr int kJsonDepth = 64;                                // objects and arrays in one another

// Fields of one JSON object, so that no input costs more than its length.
inline constexpr std::size_t kJsonFields = 64;             // in files of this project
inline constexpr std::size_t kJsonTableFields = 100'000;   // where a simulator keeps all its scenes in one object
inline constexpr std::size_t kJsonHomeFields = 4'000'000;  // where a simulator names every part of a home by a field

// Homes of simulators. Physics and navigation take memory by area and time by number of objects.
inline constexpr double kHomeWidth_m = 200;
inline constexpr double kHomeOffset_m = 1000;          // from the origin, beyond which positions lose precision
inline constexpr double kImportedObject_m = 50;        // a side of one object's box
inline constexpr std::size_t kListedObjects = 20'000;  // in a simulator's file, walls and floors among them
inline constexpr std::size_t kImportedObjects = 5000;  // to be placed in one home
inline constexpr std::size_t kImportedRooms = 200;
inline constexpr std::size_t kNamedRooms = 100;    // distinguished by the names that objects give; more are no rooms
inline constexpr std::size_t kSceneIdBytes = 200;  // an id names a file, and most file systems allow 255 bytes

// Knowledge tables: what is larger is a slip of the unit (millimetres, grams).
inline constexpr double kCategory_m = 100, kCategory_kg = 90'000;
inline constexpr double kCompleted_m = 20, kCompleted_kg = 2000;  // as a language model may state it
inline constexpr std::int64_t kReservedRows = 1 << 20;            // a damaged file must not ask for all memory
inline constexpr double kProfileCount = 100'000;                  // pixels or hands in a simulator's profile

// Templates. Starts are drawn with as many objects as they ask for, and a home has some hundreds.
inline constexpr int kCountedObjects = 1000;  // that init asks for in all, or that a goal counts to

// Runs. Many JSON readers hold numbers as doubles, which are exact for whole numbers up to 2^53.
inline constexpr std::uint64_t kSeed = 9'007'199'254'740'991;  // 2^53 - 1
inline constexpr int kTasks = 1'000'000'000;                   // of a run
inline constexpr int kAttempts = 1024;                         // for one task (dataset/candidate_number.h)

// Answers of language models, which may be anything.
inline constexpr std::size_t kAnswerBytes = std::size_t{4} << 20;  // of one HTTP answer
inline constexpr std::int64_t kAnswerTokens = 1'000'000'000;       // as a server counts them

}  // namespace unietp::limits
