#pragma once

#include <filesystem>
#include <string>

#include "cli/commands.h"
#include "cli/evaluate_options.h"

namespace unietp {

/// Prints what the model is sent at a step, "TASK:STEP", counted from 1, in the first of the modes. The steps before it
/// are those of the run in `out`, where that has the episode, else those of the demonstration.
Exit show_prompt(const std::string& place, const std::filesystem::path& out, const EvaluateRequest& request,
                 const TaskSource& tasks);

/// Prints how many episodes a run would play, and the first prompt of a model.
Exit show_plan(const EpisodePlan& plan, const EvaluateRequest& request, const TaskSource& tasks);

}  // namespace unietp
