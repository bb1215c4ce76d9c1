#include "kitchen_tasks.h"

#include <memory>

#include "tests/simulation/kitchen.h"

namespace unietp::testing {

ServedTasks kitchen_tasks() {
  const SimulatorData data{std::make_shared<const Knowledge>(kitchen_knowledge()),
                           std::make_shared<const Profile>(kitchen_profile())};
  TaskText text;
  text.id = "kitchen-1";
  text.instruction = "Put the mug on the counter.";
  text.goal_text = "(exists (?m - Mug) (exists (?c - CounterTop) (at-end (on ?m ?c))))";
  const auto task = prepare_task(std::move(text), kitchen(), data);
  ServedTasks tasks;
  tasks.made = [task](std::uint64_t seed) -> Result<SharedTask> {
    if (seed == 99) return Error{Error::Kind::Io, "/home/someone/secret.gz", {}, "cannot read /home/someone/secret.gz"};
    return task;
  };
  return tasks;
}

const std::vector<std::string>& kitchen_plan() {
  static const std::vector<std::string> kPlan{
      R"({"action": "go_to", "args": ["mug_1"]})", R"({"action": "pick_up", "args": ["mug_1"]})",
      R"({"action": "go_to", "args": ["countertop_1"]})", R"({"action": "place_on", "args": ["countertop_1"]})",
      R"({"action": "stop"})"};
  return kPlan;
}

}  // namespace unietp::testing
