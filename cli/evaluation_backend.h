#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "core/result.h"
#include "environment/task_source.h"
#include "evaluation/evaluation_manifest.h"
#include "evaluation/simulator_program.h"

namespace unietp {

/// The tasks of an evaluation in the form of the simulator in which it is acted out, and the program that does so, in a
/// folder that goes with the last copy. Empty where our own physics are the backend.
class BackendTasks {
 public:
  BackendTasks() = default;
  explicit BackendTasks(std::filesystem::path folder);

  /// Errors: those of simulator_command.
  Result<Done> write_program(const std::string& backend);

  /// What makes the simulator for each thread; empty for our own physics. `reply_s`: the time for one answer.
  SimulatorMaker simulators(double reply_s, const CommandLine& program) const;

 private:
  std::vector<std::string> command_;
  std::shared_ptr<const std::filesystem::path> folder_;
};

/// Writes the tasks of a data set in the form of a backend, and names in `selection` those that can be acted out there:
/// that the form expresses, and whose goals speak of nothing but what the runner translates. Errors: Usage for an
/// unknown backend, and where no task is left; Io; those of the export.
Result<BackendTasks> backend_tasks(const std::string& backend, const std::filesystem::path& dataset,
                                   const TaskSource& tasks, EpisodeSelection& selection, const CommandLine& program);

}  // namespace unietp
