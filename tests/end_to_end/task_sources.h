#pragma once

#include <filesystem>

#include "environment/environment.h"
#include "environment/task_source.h"

namespace unietp {

/// The committed knowledge and profiles of all simulators.
AllSimulatorData committed_simulators();

/// The data set in UNIETP_DATASET, else data_set_in_all_modes.
std::filesystem::path source_folder();
/// The tasks of a folder.
TaskSource source(const std::filesystem::path& folder = source_folder());

/// A task at its start.
Environment environment_of(const TaskSource& tasks, std::size_t position, Mode mode);

}  // namespace unietp
