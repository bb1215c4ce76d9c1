#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/result.h"
#include "environment/task.h"
#include "resources/resources.h"
#include "scene/action.h"
#include "scene/simulator.h"
#include "sense/evidence.h"
#include "templates/template.h"

namespace unietp {

/// What kind of tasks to make.
struct ProceduralOptions {
  std::vector<Simulator> simulators{kSimulators.begin(), kSimulators.end()};  // drawn with equal chances
  std::vector<Split> splits;                                                  // likewise; empty: all five
  std::vector<std::string> templates;                                         // names; empty: all of the library
  std::vector<Mode> modes{Mode::M1};  // that every task is proven solvable in; M1 always is
  Grade sense = Grade::Usual;         // that tasks make at least, as far as templates can
  int homes = 16;                     // of the training pool, for each simulator, > 0; kept in memory once made
  std::uint64_t homes_seed = 1;       // which homes these are
  int attempts = 200;                 // candidates tried for one task
};

/// Makes new tasks without end: each seed gives one, which has passed every check that `unietp generate` makes (start
/// at rest and as demanded, goal false there, expert's plan executed, must-fail mutants fail, instruction parsed back),
/// in homes of the training pool that neither the benchmark nor any data set of `unietp training` has, whatever its
/// size and seed: their numbers begin where those of data sets end. A task depends on the options, the seed and the
/// program's knowledge only. Homes are made once and shared. Thread-safe.
class Procedural {
 public:
  /// Errors: Usage for an unknown template, for splits that no chosen template has, and for numbers out of range.
  static Result<Procedural> make(std::shared_ptr<const Resources> resources, const ProceduralOptions& options);

  /// The task of a seed. Errors: Unsatisfiable when none of the attempts gave one; names the last reason.
  Result<SharedTask> task(std::uint64_t seed) const;

  const ProceduralOptions& options() const;  // as given

 private:
  struct Impl;
  std::shared_ptr<Impl> impl_;  // shared by copies: has mutexes and homes
};

}  // namespace unietp
