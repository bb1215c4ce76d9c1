#pragma once

#include <vector>

#include "generator/style.h"
#include "scene/simulator.h"
#include "sense/evidence.h"
#include "templates/template.h"

namespace unietp {

/// A place in the data set that one task will fill: what kind it is to be, and which templates may fill it.
struct TaskSlot {
  int index = 0;  // in the data set
  Simulator simulator = Simulator::Ai2thor;
  Split split = Split::Atomic;
  std::vector<std::size_t> templates;  // positions in Resources::templates, ascending; not empty
  std::vector<Grade> least;            // of each of them: what its tasks have to reach, as far as it can at all
  std::size_t first_template = 0;      // position in `templates` of the one that is tried first
  std::vector<Style> styles;           // of the Linguistic split: the phenomena, in the order in which they are tried
};

}  // namespace unietp
