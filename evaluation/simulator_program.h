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

/// A program that acts tasks out in a simulator, of python/adapters; acting.py there describes the protocol.
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

/// An answer to `act`. An object that is not there `now` is one that the action makes in our physics, `ours`. Errors:
/// Parse and Schema, for a line that is none, an object, state or relation that is unknown, and what the program
/// reports as an error.
Result<SimulatorAnswer> read_simulator_answer(std::string_view line, int id, const Scene& now, const Delta& ours);

/// Writes the program of a backend, one of simulator_backends(), into a folder, and gives the command that starts it.
/// Errors: Usage for another backend; Io.
Result<std::vector<std::string>> simulator_command(const std::string& backend, const std::filesystem::path& folder);
/// Names of the backends that are not our own physics.
const std::vector<std::string>& simulator_backends();

}  // namespace unietp
