#include "scores/episode_view.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "core/base64.h"
#include "core/png.h"
#include "core/text.h"
#include "report/goal_prose.h"
#include "simulation/picture.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kTextShown = 4000, kObservationShown = 1500;  // bytes of a text

/// At most so many bytes, and no half a character.
std::string cut(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80) --most;
  return text.substr(0, most) + " …";
}

/// "101": which parts are met.
std::string bits(const std::vector<bool>& parts) {
  std::string text;
  for (const bool part : parts) text += part ? '1' : '0';
  return text;
}

double rounded(double value) { return std::round(value * 1000) / 1000; }

std::string part_text(const ScoredPart& part) {
  std::vector<std::string> lines;
  for (const ProseLine& line : goal_prose(part.formula)) lines.push_back(line.text);
  return join(lines, " ");
}

Json step_view(const EpisodeStep& step, const ReplayedStep& replayed, bool boxes) {
  Json seen = Json::array(), acts = Json::array();
  if (boxes) {
    for (const VisibleObject& object : replayed.pictured)
      seen.push_back({object.id, object.box[0], object.box[1], object.box[2], object.box[3]});
  }
  for (const ReplayedAction& action : replayed.actions) {
    Json act{{"text", replayed.unreadable.empty() ? to_text(action.record.command) : ""},
             {"ok", action.record.success},
             {"why", action.record.success ? "" : action.record.feedback},
             {"progress", rounded(action.progress)},
             {"reached", action.reached},
             {"parts", bits(action.parts)}};
    if (!action.record.command.args.empty() && action.record.command.args.front().box) {
      act["box"] = *action.record.command.args.front().box;
      act["object"] = action.object;
    }
    acts.push_back(std::move(act));
  }
  return {{"thinking", cut(step.thinking, kTextShown)},
          {"said", cut(step.reply, kTextShown)},
          {"unreadable", replayed.unreadable},
          {"seen", std::move(seen)},
          {"acts", std::move(acts)},
          {"told", cut(replayed.observation, kObservationShown)}};
}

}  // namespace

std::string view_picture(const Environment& environment, int width) {
  const Observation& now = environment.observe();
  const int shown = std::min(width, now.image_width);
  const int height = std::max(1, now.image_height * shown / std::max(1, now.image_width));
  const auto picture = environment.render(shown, height);
  if (!picture) return "";
  auto png = few_colors_png(picture->width, picture->height, picture->rgb);
  return png ? std::move(*png) : "";
}

Json episode_view(const EpisodeRecord& record, const ReplayedEpisode& replayed, const EnvironmentTask& task,
                  const std::vector<Command>& expert, const EpisodePictures& pictures) {
  Json goal = Json::array(), parts = Json::array(), steps = Json::array(), way = Json::array(), images = Json::array();
  for (const ProseLine& line : goal_prose(task.goal)) goal.push_back({line.depth, line.text});
  for (const ScoredPart& part : replayed.parts) parts.push_back({name_of(part.kind), part_text(part)});
  for (std::size_t i = 0; i < replayed.steps.size(); ++i)
    steps.push_back(step_view(record.steps[i], replayed.steps[i], !pictures.empty()));
  for (const Command& command : expert) way.push_back(to_text(command));
  for (const std::string& png : pictures) images.push_back(base64(png));
  const Profile& camera = *task.data.profile;
  Json json{{"instruction", task.text.instruction},
            {"goal", std::move(goal)},
            {"parts", std::move(parts)},
            {"met", bits(replayed.parts_at_start)},
            {"told", cut(replayed.first_observation, kObservationShown)},
            {"steps", std::move(steps)},
            {"expert", std::move(way)},
            {"width", camera.image_width},
            {"height", camera.image_height},
            {"images", std::move(images)}};
  if (record.error) json["error"] = record.error->message;
  return json;
}

}  // namespace unietp
