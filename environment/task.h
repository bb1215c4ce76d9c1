#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "core/result.h"
#include "grounding/home.h"
#include "grounding/household.h"
#include "logic/formula.h"
#include "logic/monitor.h"
#include "record/task_record.h"
#include "scene/comparisons.h"
#include "scene/scene.h"
#include "scene/trace.h"
#include "simulation/known_start.h"
#include "simulation/profile.h"

namespace unietp {

/// The facts about a simulator's categories and the limits of its agent. Shared: environments and tasks of several
/// threads read them, and each keeps them alive.
struct SimulatorData {
  std::shared_ptr<const Knowledge> knowledge;
  std::shared_ptr<const Profile> profile;
  std::shared_ptr<const Household> household{};  // where things usually are, for the expert; nullptr: it does not know
};
/// In the order of kSimulators.
using AllSimulatorData = std::array<SimulatorData, kSimulators.size()>;

/// What a task says, without its start.
struct TaskText {
  std::string id, instruction;
  std::string split, template_name, layout;  // as the data set's line has them
  std::string goal_text;
  std::vector<TaskRecord::Count> expert;  // steps and failures of its demonstrations, by mode
};

/// A task that is ready to be acted in: what it says, its start, and what was worked out of the start once for all
/// episodes. Immutable; environments on several threads may share it.
struct EnvironmentTask {
  TaskText text;
  Simulator simulator = Simulator::Ai2thor;
  Formula goal;
  SimulatorData data;
  Scene start;

  // Of the start, for each reset.
  KnownStart known;
  Compared compared;            // what the goal compares
  bool compares_later = false;  // also in states after the start
  FactReader reader;
  Facts facts;
  Monitor monitor;  // has observed the start
};
using SharedTask = std::shared_ptr<const EnvironmentTask>;

/// Prepares a task. Errors: Schema when the start cannot be built (World::create); Parse when the goal cannot be read.
Result<SharedTask> prepare_task(TaskText text, Scene start, const SimulatorData& data);
/// The same for a start that grew out of a prepared home (start_in), at the cost of what it changes.
Result<SharedTask> prepare_task(TaskText text, Scene start, const SimulatorData& data, const Home& home);
/// The same with what is known of the start already.
Result<SharedTask> prepare_task(TaskText text, Scene start, const SimulatorData& data, KnownStart known);

}  // namespace unietp
