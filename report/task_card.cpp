#include "report/task_card.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "core/base64.h"
#include "core/png.h"
#include "core/text.h"
#include "grounding/scene_svg.h"
#include "report/goal_prose.h"
#include "simulation/picture.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

PlanCard plan_of(Mode mode, const DemonstrationRecord& shown) {
  PlanCard plan{mode, {}};
  for (const StepRecord& step : shown.steps)
    plan.steps.push_back({to_text(step.command), step.success, step.success ? "" : step.feedback});
  return plan;
}

}  // namespace

ShownTask shown_task(const FinishedTask& task) {
  ShownTask shown{task.record, {}};
  for (const auto& [mode, demonstration] : task.shown) shown.plans.push_back(plan_of(mode, demonstration));
  return shown;
}

Result<StartPictures> pictures_of(const FinishedSet& set, const TaskRecord& task, const Profile& profile, int width) {
  const auto scene = read_start_scene(set.folder, task);
  if (!scene) return scene.error();
  Profile camera = profile;
  if (width < profile.image_width) {
    camera.image_height = std::max(1, profile.image_height * width / profile.image_width);
    camera.image_width = width;
  }
  Rays rays;
  const Picture seen = picture_of(*scene, camera, rays);
  auto png = few_colors_png(seen.width, seen.height, seen.rgb);
  if (!png) return png.error();
  return StartPictures{replace_all(scene_svg(*scene), "\n", ""), std::move(*png)};
}

Json card_json(const ShownTask& shown, const std::string& png) {
  const TaskRecord& task = shown.record;
  Json goal = Json::array();
  for (const ProseLine& line : goal_prose(task.goal_tree)) goal.push_back({line.depth, line.text});
  Json plans = Json::array();
  for (const PlanCard& plan : shown.plans) {
    Json steps = Json::array();
    for (const auto& step : plan.steps) steps.push_back({step.text, step.success ? 1 : 0, step.feedback});
    plans.push_back({{"mode", name_of(plan.mode)}, {"steps", std::move(steps)}});
  }
  Json sense = Json::array();
  for (const auto& part : task.sense) sense.push_back({part.part, part.grade, part.why});
  return {{"style", task.style}, {"goal", std::move(goal)},   {"formula", task.goal_text},
          {"edits", task.edits}, {"purpose", task.purpose},   {"because", task.because},
          {"grade", task.grade}, {"sense", std::move(sense)}, {"plans", std::move(plans)},
          {"view", base64(png)}};
}

}  // namespace unietp
