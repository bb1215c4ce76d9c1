#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/result.h"
#include "record/dataset_reader.h"
#include "report/data_set.h"
#include "simulation/profile.h"

namespace unietp {

/// A demonstration for display.
struct PlanCard {
  struct Step {
    std::string text;  // "pick_up(mug_1)"
    bool success = true;
    std::string feedback;
  };
  Mode mode = Mode::M1;
  std::vector<Step> steps;
};

/// A task for display, with one plan per mode.
struct ShownTask {
  TaskRecord record;
  std::vector<PlanCard> plans;
};
ShownTask shown_task(const FinishedTask& task);

/// The start of a task as pictures.
struct StartPictures {
  std::string svg;  // from above, without line ends
  std::string png;  // what the agent sees, with a reduced palette
};
/// `width`: of the PNG in pixels, at most the camera's. Deterministic. Errors: those of reading the scene.
Result<StartPictures> pictures_of(const FinishedSet& set, const TaskRecord& task, const Profile& profile, int width);

/// What assets/task.js shows in addition to id, simulator, split, template, instruction and drawing: goal, plans, view,
/// …
nlohmann::ordered_json card_json(const ShownTask& task, const std::string& png);

}  // namespace unietp
