#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/result.h"
#include "grounding/layout_library.h"
#include "resources/resources.h"

namespace unietp {

/// A home that is still to be made. Errors of making: those of generate_layout.
struct WantedHome {
  std::string id;
  std::function<Result<Scene>()> make;  // the backends and recipes that it was asked of must live as long
};

/// What homes are made from, each in the order of kSimulators.
struct Makings {
  std::vector<Backend> backends;
  std::vector<LayoutRecipe> recipes;
};
/// Errors: those of load_backends, all of them, or of load_recipe.
struct MakingsReading {
  Makings makings;
  std::vector<Error> errors;
};
MakingsReading load_makings(const DataFolders& folders);

struct NewHomes {
  int count = 1;
  std::uint64_t seed = 1;
  int rooms = 0, objects = 0;  // 0: not asked for
};
/// New homes: of the training pool, or of another stream when a size is asked for; 30 objects a room where only the
/// rooms are. No home depends on how many there are.
std::vector<WantedHome> new_homes(const Makings& makings, Simulator simulator, const NewHomes& wanted);

/// Homes of the benchmark, in its order: all of them, or those with the ids.
/// Errors: those of benchmark_layouts; Usage for an id that it lacks, with the nearest one.
Result<std::vector<WantedHome>> benchmark_homes(const Makings& makings, const DataFolders& folders, bool all,
                                                const std::vector<std::string>& ids);

}  // namespace unietp
