#pragma once

#include <filesystem>
#include <string>

#include "cli/commands.h"
#include "core/result.h"
#include "environment/task_source.h"
#include "serve/protocol.h"

namespace unietp {

class CommandParser;

/// Which tasks a person or an agent is to act in.
struct TaskChoice {
  std::filesystem::path folder;  // a data set; empty: none
  bool procedural = false;
  std::string simulators, splits;  // of new tasks; "": all
  TaskSource::Kept kept = {};      // of a data set, for reuse
};

/// Adds `--procedural`, `--simulators` and `--splits`.
void add_procedural_options(CommandParser& command, TaskChoice& choice);

/// Loads what the tasks need. Errors: those of the resources, of TaskSource and of Procedural.
struct TasksReading {
  ServedTasks tasks;
  std::vector<Error> errors;  // empty when sound
};
TasksReading served_tasks(const TaskChoice& choice, const CommandLine& program);

}  // namespace unietp
