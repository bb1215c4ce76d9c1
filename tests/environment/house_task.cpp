#include "tests/environment/house_task.h"

#include <stdexcept>

#include "tests/expert/house.h"

namespace unietp::testing {

SharedTask house_task(const std::string& goal) {
  static const SimulatorData kData{std::make_shared<const Knowledge>(house_knowledge()),
                                   std::make_shared<const Profile>(house_profile())};
  static const Scene kStart = at_rest(house());
  TaskText text;
  text.id = "house-1";
  text.instruction = goal.find("SideTable") != std::string::npos ? "Put a mug on the side table." : "Reach " + goal;
  text.layout = kStart.id;
  text.goal_text = goal;
  auto task = prepare_task(std::move(text), kStart, kData);
  if (!task) throw std::runtime_error(format(task.error()));
  return *task;
}

Environment house_environment(const Settings& settings, const std::string& goal) {
  auto made = Environment::make(goal.empty() ? house_task() : house_task(goal), settings);
  if (!made) throw std::runtime_error(format(made.error()));
  return std::move(*made);
}

std::string say(const std::string& action, const std::string& id) {
  return R"({"action": ")" + action + R"(", "args": [)" + (id.empty() ? "" : '"' + id + '"') + "]}";
}

}  // namespace unietp::testing
