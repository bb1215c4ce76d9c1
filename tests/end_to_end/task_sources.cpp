#include "task_sources.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "data_set.h"
#include "tests/support/committed_knowledge.h"

namespace unietp {

AllSimulatorData committed_simulators() {
  AllSimulatorData data;
  for (const Simulator simulator : kSimulators) {
    SimulatorData& one = data[static_cast<std::size_t>(simulator)];
    one.knowledge = std::shared_ptr<const Knowledge>(std::shared_ptr<void>(), &committed_knowledge(simulator));
    auto profile = load_profile(std::filesystem::path(UNIETP_SOURCE_DIR) / "data/simulators", simulator);
    EXPECT_TRUE(profile);
    one.profile = std::make_shared<const Profile>(std::move(*profile));
  }
  return data;
}

std::filesystem::path source_folder() {
  const char* given = std::getenv("UNIETP_DATASET");
  return given == nullptr ? data_set_in_all_modes() : std::filesystem::path(given);
}

TaskSource source(const std::filesystem::path& folder) {
  auto opened = TaskSource::open(folder, committed_simulators());
  EXPECT_TRUE(opened) << format(opened.error());
  return std::move(*opened);
}

Environment environment_of(const TaskSource& tasks, std::size_t position, Mode mode) {
  auto task = tasks.task(position);
  EXPECT_TRUE(task) << format(task.error());
  auto made = Environment::make(*task, settings_for(mode));
  EXPECT_TRUE(made) << format(made.error());
  return std::move(*made);
}

}  // namespace unietp
