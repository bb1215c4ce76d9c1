#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "grounding/layout.h"

namespace unietp {

/// One home of the benchmark: what it takes to make it again, a row of data/layouts/benchmark.csv.
struct BenchmarkLayout {
  std::string id;  // "ai2thor-benchmark-07"
  Simulator simulator = Simulator::Ai2thor;
  std::uint64_t seed = 0;
  int rooms = 7;
  int objects = 210;  // furniture and small things together
  bool operator==(const BenchmarkLayout&) const = default;
};

/// What reading data/layouts/benchmark.csv gives.
struct BenchmarkTable {
  std::vector<BenchmarkLayout> layouts;  // rows with an error are left out
  std::vector<Error> errors;             // all of them, with line and column
};
/// A table with the columns id, simulator, seed, rooms and objects. Errors: those of read_csv; an unknown simulator; a
/// number out of its range (rooms 4 to 12, objects 50 to 600); an id, or a simulator and seed, that stands twice.
BenchmarkTable read_benchmark(std::string_view where, std::string_view text);
/// `<folder>/benchmark.csv`. Errors: Io, or the table's first error.
Result<std::vector<BenchmarkLayout>> benchmark_layouts(const std::filesystem::path& folder);

/// The home of a row. Deterministic: equal rows and tables give equal bytes. Errors: those of generate_layout.
Result<Scene> benchmark_layout(const BenchmarkLayout& layout, const LayoutRecipe& recipe, const Knowledge& knowledge,
                               const Profile& profile);

/// Home number `n` of the training pool of `seed`: as many as wanted. Benchmark and training draw from streams of
/// different names, so that no n and no seed leads to a home of the benchmark. It is as large as the
/// recipe's scale says. Errors: those of generate_layout.
Result<Scene> training_layout(const LayoutRecipe& recipe, const Knowledge& knowledge, const Profile& profile,
                              std::uint64_t n, std::uint64_t seed);

}  // namespace unietp
