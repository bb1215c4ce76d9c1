#pragma once

#include <filesystem>

#include "core/result.h"
#include "resources/resources.h"
#include "validator/validation_options.h"

namespace unietp {

/// All that the validator can hold a data set against, from the other rooms: texts, templates, homes, starts and
/// derived files. `resources` must outlive it. `licences`, `runs`: data/licences.csv and the folder of
/// benchmark-homes.csv. Errors: those of read_known_homes.
Result<ValidationOptions> full_validation(const Resources& resources, const std::filesystem::path& licences,
                                          const std::filesystem::path& runs);

}  // namespace unietp
