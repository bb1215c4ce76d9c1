#pragma once

#include <functional>
#include <string>
#include <vector>

#include "logic/formula.h"
#include "scene/scene.h"
#include "validator/problem.h"

namespace unietp {

/// A text that is to say a goal, with what its reader may know.
struct StatedGoal {
  std::string text, writer, style, template_name;
  Simulator simulator = Simulator::Ai2thor;
  Formula goal;
  std::vector<Formula> constraints;  // that the start meets
  std::vector<std::string> around;   // categories of the objects and types of the rooms of the start, sorted
  const Scene* home = nullptr;       // the start scene
  const std::vector<std::string>* phenomena = nullptr;  // that it says it shows; nullptr: says nothing
  std::string english;                                  // that it is in: "us" or "gb"
  std::string phrasings;  // the set of turns of phrase that it is to be of: "everyday", "all", …
};

/// Reads English: what is wrong with a text, without task and place. The validator has no grammar of its own; whoever
/// calls it brings one. Called by several threads at once.
using TextCheck = std::function<std::vector<Problem>(const StatedGoal&)>;

}  // namespace unietp
