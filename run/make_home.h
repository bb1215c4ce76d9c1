#pragma once

#include <string_view>
#include <utility>

#include "core/result.h"
#include "dataset/configuration.h"
#include "resources/resources.h"
#include "scene/scene.h"

namespace unietp {

/// Home number `number`, from 0, of a simulator in a run that is given no homes. Depends only on the configuration's
/// source of homes, its seed and size, the simulator and the number. Deterministic. Errors: those of generate_layout,
/// after a few tries; Usage for a number that the benchmark does not have.
Result<Scene> make_home(const RunConfiguration& configuration, const Resources& resources, Simulator simulator,
                        int number);

/// The simulator and number of the home of this name. Errors: Usage for a name that no home of the run has.
Result<std::pair<Simulator, int>> home_number(const RunConfiguration& configuration, const Resources& resources,
                                              std::string_view name);

/// The same by its name. Errors: also Usage for a name that no home of the run has.
Result<Scene> make_home(const RunConfiguration& configuration, const Resources& resources, std::string_view name);

}  // namespace unietp
