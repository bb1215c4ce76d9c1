#include "simulation/mode_rules.h"

namespace unietp {

StepLimits limits_of(Mode mode) { return mode == Mode::M3 ? StepLimits{150, 30} : StepLimits{50, 10}; }

GlobalInformation global_information(const Scene& start, Mode mode) {
  GlobalInformation known;
  for (const Room& room : start.rooms) known.rooms.push_back(room.id);
  for (const Node& node : start.nodes) {
    if (node.movable && mode == Mode::M1) known.movables.push_back(node.id);
    if (!node.movable && mode != Mode::M3) known.furniture.push_back(node.id);
  }
  return known;
}

bool tells_boxes(Mode mode) { return mode != Mode::M3; }

}  // namespace unietp
