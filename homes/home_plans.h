#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/result.h"
#include "grounding/layout_library.h"
#include "resources/resources.h"

namespace unietp {

/// A home that is not made yet. `make` is deterministic. Errors: those of generate_layout.
struct HomePlan {
  std::string id;
  std::function<Result<Scene>()> make;  // refers to the inputs that it was planned with
};

/// What homes are made from, both in the order of kSimulators.
struct HomeInputs {
  std::vector<Backend> backends;
  std::vector<LayoutRecipe> recipes;
};
/// Errors: those of load_backends, all of them, or of load_recipe.
struct HomeInputsReading {
  HomeInputs inputs;
  std::vector<Error> errors;
};
HomeInputsReading load_home_inputs(const DataFolders& folders);

/// Which new homes to plan.
struct NewHomeOptions {
  int count = 1;
  std::uint64_t seed = 1;
  int rooms = 0, objects = 0;  // 0: the usual number
};
/// New homes: those of training data, or others when a size is given (30 objects per room unless their number is given
/// too). A home does not depend on how many are planned.
std::vector<HomePlan> new_homes(const HomeInputs& inputs, Simulator simulator, const NewHomeOptions& wanted);

/// Homes of the benchmark in its order: all, or those with these ids.
/// Errors: those of benchmark_layouts; Usage for an id that it lacks, with the nearest one.
Result<std::vector<HomePlan>> benchmark_homes(const HomeInputs& inputs, const DataFolders& folders, bool all,
                                              const std::vector<std::string>& ids);

}  // namespace unietp
