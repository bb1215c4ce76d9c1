#include "procedural/simulator_data.h"

namespace unietp {

AllSimulatorData simulator_data(const std::shared_ptr<const Resources>& resources) {
  AllSimulatorData data;
  for (const Simulator simulator : kSimulators) {
    const Backend& backend = resources->backend(simulator);
    data[static_cast<std::size_t>(simulator)] = {std::shared_ptr<const Knowledge>(resources, &backend.knowledge),
                                                 std::shared_ptr<const Profile>(resources, &backend.profile),
                                                 resources->recipe(simulator).household};
  }
  return data;
}

}  // namespace unietp
