#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "environment/acting_simulator.h"

namespace unietp {

/// A program that runs tasks in a simulator: a runner of python/adapters, whose first lines describe the protocol.
struct SimulatorProgramOptions {
  std::vector<std::string> arguments;  // the program and its arguments
  std::filesystem::path folder;        // the tasks in the simulator's form
  double reply_s = 120;                // for one answer
  const std::atomic<bool>* stop = nullptr;
};

/// Makes a simulator for a thread; called from that thread.
using SimulatorMaker = std::function<SharedSimulator()>;

/// The program as a simulator. It is started with the first episode, and anew after an error.
SharedSimulator simulator_program(SimulatorProgramOptions options);

/// An answer to `act`. Errors: Parse and Schema, for a line that is none, an object, state or relation that is unknown,
/// and what the program reports as an error.
Result<SimulatorAnswer> read_simulator_answer(std::string_view line, int id, const Scene& now);

/// The command that starts the runner of a backend: its name among simulator_backends(). Errors: Usage for another.
Result<std::vector<std::string>> simulator_command(const std::string& backend);
/// Names of the backends that are not our own physics.
const std::vector<std::string>& simulator_backends();

}  // namespace unietp
